(** The largest errors of eqs 15, 16, 18 and 20 on the boundary for b/a = 3/2, enclosed: claim Z5 of Im and Avouac.

    At the point of the boundary with the double root r, the groups are those of BoundaryCurve.v. Its normal stress over eq 15's at
    the same velocity is (w - 1)^2/kappa, and over eq 16's (w + 1)^2/kappa, with w^2 = b/a. Its velocity over eq 20's at the same
    normal stress is 2 sqrt(eta kappa), and over eq 18's that over b/a - 1. *)

From Slipmode Require Export BoundaryCurve.
From Coq Require Import Rsqrt_def.
From Interval Require Import Tactic.
From Interval.Float Require Import Specific_ops Specific_stdz.

(** Numbers of Coq's integers: with the machine's numbers, which the library takes by default, their axioms would be assumed. *)
Module Numbers := SpecificFloat StdZRadix2.
Module OnIntegers := IntervalTactic Numbers.
Import OnIntegers.

Definition beta : R := 3 / 2.
Definition w : R := sqrt beta.

Definition error_15 (r : R) : R := (w - 1) ^ 2 / kappa_at beta r - 1.
Definition error_16 (r : R) : R := (w + 1) ^ 2 / kappa_at beta r - 1.
Definition error_18 (r : R) : R := 2 * sqrt (eta_at beta r * kappa_at beta r) / (beta - 1) - 1.
Definition error_20 (r : R) : R := 2 * sqrt (eta_at beta r * kappa_at beta r) - 1.

Section Units.

Variables a b D K M : R.
Hypotheses (a_pos : 0 < a) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M) (ratio : b = beta * a).

(** Eqs 15 and 16, and the left sides of eqs 18 and 20. *)
Let right_15 := K * D / (sqrt (b) - sqrt (a)) ^ 2.
Let right_16 := K * D / (sqrt (b) + sqrt (a)) ^ 2.
Let left_18 (V sigma : R) := 2 * V * sqrt (M * K) / (Rabs (a - b) * sigma).
Let left_20 (V sigma : R) := 2 * V * sqrt (M * K) / (a * sigma).

(** The errors are those of the equations at the point V, sigma whose groups are those of r. *)
Theorem errors (V sigma r : R) : 0 < V -> 0 < sigma ->
  M * V ^ 2 / (sigma * a * D) = eta_at beta r -> K * D / (a * sigma) = kappa_at beta r ->
  sigma / right_15 - 1 = error_15 r /\ sigma / right_16 - 1 = error_16 r /\
  left_18 V sigma - 1 = error_18 r /\ left_20 V sigma - 1 = error_20 r.
Proof using a_pos D_pos K_pos M_pos ratio.
  intros v s E Q; unfold right_15, right_16, left_18, left_20, error_15, error_16, error_18, error_20; rewrite <- E, <- Q.
  assert (A : sqrt a ^ 2 = a) by (apply root_squared; lra); assert (A' : 0 < sqrt a) by now apply sqrt_lt_R0.
  assert (B : sqrt b = w * sqrt a) by (rewrite ratio; unfold w; apply sqrt_mult_alt; unfold beta; lra).
  assert (U : 1 < w) by (unfold w, beta; interval with (i_prec 60)).
  assert (P : sqrt (M * V ^ 2 / (sigma * a * D) * (K * D / (a * sigma))) = V * sqrt (M * K) / (a * sigma)).
  { replace (M * V ^ 2 / (sigma * a * D) * (K * D / (a * sigma))) with ((V / (a * sigma)) ^ 2 * (M * K)) by (field; lra).
    rewrite sqrt_mult_alt by (apply pow2_ge_0); rewrite sqrt_pow2 by (left; pos); field; lra. }
  assert (T : Rabs (a - b) = (beta - 1) * a) by (rewrite ratio; unfold beta; rewrite Rabs_left; lra).
  assert (G : 0 < (w - 1) * sqrt a) by (apply Rmult_lt_0_compat; lra).
  assert (N : w * sqrt a - sqrt a <> 0) by (apply Rgt_not_eq; red; lra).
  assert (N' : w * sqrt a + sqrt a <> 0) by (apply Rgt_not_eq; red; pos).
  rewrite B, P, T; repeat split.
  - apply (f_equal (fun x => x - 1)); transitivity (sigma * (w - 1) ^ 2 * sqrt a ^ 2 / (K * D)).
    + field; repeat split; first [assumption | lra].
    + rewrite A; field; lra.
  - apply (f_equal (fun x => x - 1)); transitivity (sigma * (w + 1) ^ 2 * sqrt a ^ 2 / (K * D)).
    + field; repeat split; first [assumption | lra].
    + rewrite A; field; lra.
  - unfold beta; field; lra.
  - field; lra.
Qed.

End Units.

(** η/κ, which is M V²/(K D_c²), at the velocity of the corner of eqs 15 and 18. *)
Definition corner : R := (w + 1) ^ 2 / (4 * (w - 1) ^ 2).

Lemma squared : w ^ 2 = beta.
Proof. unfold w; apply root_squared; unfold beta; lra. Qed.

Lemma above_one (x y : R) : 0 < y -> y < x -> 0 < x / y - 1.
Proof. intros Y H; apply (Rmult_lt_reg_r y); [exact Y|]; replace ((x / y - 1) * y) with (x - y) by (field; lra); lra. Qed.

(** Negative where η exceeds corner κ, of the sign of corner κ - η. *)
Definition past (r : R) : R := corner * (r ^ 2 * ((2 * r + 1) * beta - (r + 1) ^ 2)) - (beta - (r + 1) ^ 2).

Lemma past_is (r : R) : 0 < r -> past r = 2 * r * (r + 1) ^ 2 * (corner * kappa_at beta r - eta_at beta r).
Proof. intros P; unfold past, kappa_at, eta_at; field; lra. Qed.

Lemma before_corner (r : R) : 0 < r -> eta_at beta r <= corner * kappa_at beta r -> 125179017 / 1000000000 < r.
Proof.
  intros P H; apply Rnot_le_lt; intros L.
  assert (N : past r < 0).
  { assert (0 <= r) by lra; unfold past, corner, w, beta; interval with (i_bisect r, i_autodiff r, i_prec 60). }
  rewrite past_is in N by exact P; assert (0 < 2 * r * (r + 1) ^ 2) by pos; nra.
Qed.

Lemma after_corner (r : R) : 0 < r < w - 1 -> corner * kappa_at beta r <= eta_at beta r -> r < 125179018 / 1000000000.
Proof.
  intros [P Q] H; apply Rnot_le_lt; intros L.
  assert (N : 0 < past r).
  { assert (r <= 225 / 1000) by (apply Rlt_le, Rlt_le_trans with (1 := Q); unfold w, beta; interval with (i_prec 60)).
    unfold past, corner, w, beta; interval with (i_bisect r, i_autodiff r, i_prec 60). }
  rewrite past_is in N by exact P; assert (0 < 2 * r * (r + 1) ^ 2) by pos; nra.
Qed.

(** The point of the boundary at the velocity of the corner. *)
Lemma at_corner : exists r, 125179017261 / 1000000000000 <= r <= 125179017262 / 1000000000000 /\ eta_at beta r = corner * kappa_at beta r.
Proof.
  destruct (IVT past (125179017261 / 1000000000000) (125179017262 / 1000000000000)) as (r & R & Z).
  - unfold past; reg.
  - lra.
  - unfold past, corner, w, beta; interval with (i_prec 80).
  - unfold past, corner, w, beta; interval with (i_prec 80).
  - exists r; split; [exact R|]; rewrite past_is in Z by lra.
    apply Rmult_integral in Z; destruct Z as [Z|Z]; [exfalso; assert (0 < 2 * r * (r + 1) ^ 2) by (assert (0 < r) by lra; pos); lra | lra].
Qed.

(** Claim Z5, eq 15: up to the velocity of the corner its error lies between 0 and 0.6762586, and reaches 0.6762585 there. *)
Theorem Z5_15 :
  (forall r, 0 < r < w - 1 -> eta_at beta r <= corner * kappa_at beta r -> 0 < error_15 r < 6762586 / 10000000) /\
  (exists r, 0 < r < w - 1 /\ eta_at beta r = corner * kappa_at beta r /\ 6762585 / 10000000 < error_15 r).
Proof.
  split.
  - intros r [P Q] H; apply before_corner in H; [|exact P].
    assert (r <= 225 / 1000) by (apply Rlt_le, Rlt_le_trans with (1 := Q); unfold w, beta; interval with (i_prec 60)).
    split; [|unfold error_15, kappa_at, w, beta; interval with (i_bisect r, i_autodiff r, i_prec 60)].
    assert (U : 1 < w) by (unfold w, beta; interval with (i_prec 60)).
    assert (F : 2 * (r + 1) ^ 2 * ((w - 1) ^ 2 - kappa_at beta r) = (w - 1 - r) * (r * (w - 1 - r) + 2 * (w - 1) * (r + 1))).
    { rewrite <- squared; unfold kappa_at; field; lra. }
    assert (0 < (w - 1 - r) * (r * (w - 1 - r) + 2 * (w - 1) * (r + 1))) by (assert (0 < w - 1 - r) by lra; assert (0 < w - 1) by lra; pos).
    assert (0 < 2 * (r + 1) ^ 2) by pos; assert (N : 0 < (w - 1) ^ 2 - kappa_at beta r) by nra.
    assert (O := proj2 (proj2 (arcs w r ltac:(lra) ltac:(lra) ltac:(lra)) (or_introl (conj P Q)))); rewrite squared in O.
    apply above_one; lra.
  - destruct at_corner as (r & R & E); exists r; split; [|split; [exact E|]].
    + split; [lra|]; apply Rle_lt_trans with (1 := proj2 R); unfold w, beta; interval with (i_prec 60).
    + unfold error_15, kappa_at, w, beta; interval with (i_prec 60).
Qed.

(** Claim Z5, eq 18: from the velocity of the corner on its error lies between -0.4034334 and 0, and reaches -0.4034333 there. *)
Theorem Z5_18 :
  (forall r, 0 < r < w - 1 -> corner * kappa_at beta r <= eta_at beta r -> - 4034334 / 10000000 < error_18 r < 0) /\
  (exists r, 0 < r < w - 1 /\ eta_at beta r = corner * kappa_at beta r /\ error_18 r < - 4034333 / 10000000).
Proof.
  assert (P18 : forall r, 0 < r -> error_18 r = sqrt ((beta - (r + 1) ^ 2) * ((2 * r + 1) * beta - (r + 1) ^ 2)) / (r + 1) ^ 2 / (beta - 1) - 1).
  { intros r P; unfold error_18; rewrite product_at by lra.
    replace (4 * (r + 1) ^ 4) with ((2 * (r + 1) ^ 2) ^ 2) by ring.
    rewrite sqrt_div_alt by (assert (0 < r + 1) by lra; pos); rewrite sqrt_pow2 by (assert (0 < r + 1) by lra; left; pos).
    unfold beta; field; lra. }
  split.
  - intros r [P Q] H; apply after_corner in H; [|split; assumption]; rewrite P18 by exact P; split.
    + unfold beta; interval with (i_bisect r, i_autodiff r, i_prec 60).
    + apply (Rmult_lt_reg_r ((r + 1) ^ 2 * (beta - 1))); [assert (0 < r + 1) by lra; unfold beta; nra|].
      rewrite Rmult_0_l; unfold beta; set (x := sqrt _).
      replace ((x / (r + 1) ^ 2 / (3 / 2 - 1) - 1) * ((r + 1) ^ 2 * (3 / 2 - 1))) with (x - (r + 1) ^ 2 / 2) by (field; lra).
      apply Rlt_minus; unfold x; rewrite <- (sqrt_pow2 ((r + 1) ^ 2 / 2)) by (assert (0 < r + 1) by lra; left; pos).
      apply sqrt_lt_1_alt; split.
      * interval with (i_bisect r, i_prec 60).
      * apply Rminus_gt_0_lt; replace (_ - _) with (3 / 4 * r * (2 + 6 * r - r ^ 3)) by field.
        apply Rmult_lt_0_compat; [lra | interval with (i_prec 60)].
  - destruct at_corner as (r & R & E); exists r; split; [|split; [exact E|]].
    + split; [lra|]; apply Rle_lt_trans with (1 := proj2 R); unfold w, beta; interval with (i_prec 60).
    + rewrite P18 by lra; unfold beta; interval with (i_prec 60).
Qed.

(** The triple root, at the cusp. *)
Definition is_cusp (q : R) : Prop := (q + 1) ^ 3 = beta * (3 * q + 1).

Lemma cusp_enclosed : exists q, is_cusp q /\ - 33981200752 / 10000000000 <= q <= - 33981200751 / 10000000000.
Proof.
  destruct (IVT (fun q => (q + 1) ^ 3 - beta * (3 * q + 1)) (- 33981200752 / 10000000000) (- 33981200751 / 10000000000)) as (q & Q & Z).
  - reg.
  - lra.
  - unfold beta; lra.
  - unfold beta; lra.
  - exists q; split; [unfold is_cusp; lra | exact Q].
Qed.

(** Claim Z5, eq 16: on its arc, from zero velocity to the cusp, its error lies between 0 and 0.1597538, and reaches 0.1597537 at the
    cusp. *)
Theorem Z5_16 : exists q, is_cusp q /\ 1597537 / 10000000 < error_16 q /\
  forall r, q <= r < - 1 - w -> 0 < error_16 r < 1597538 / 10000000.
Proof.
  destruct cusp_enclosed as (q & C & Q); exists q; split; [exact C|]; split.
  - unfold error_16, kappa_at, w, beta; interval with (i_prec 60).
  - intros r [L H]; assert (U : 1 < w < 123 / 100) by (unfold w, beta; split; interval with (i_prec 60)).
    assert (L' : - 33981200752 / 10000000000 <= r) by lra.
    assert (H' : r <= - 22 / 10) by (apply Rlt_le, Rlt_le_trans with (1 := H); unfold w, beta; interval with (i_prec 60)).
    split; [|unfold error_16, kappa_at, w, beta; interval with (i_bisect r, i_autodiff r, i_prec 60)].
    assert (F : 2 * (r + 1) ^ 2 * ((w + 1) ^ 2 - kappa_at beta r) = - (r + 1 + w) * - ((r + 1) ^ 2 + (1 + 3 * w) * (r + 1) - w)).
    { rewrite <- squared; unfold kappa_at; field; lra. }
    assert (0 < - ((r + 1) ^ 2 + (1 + 3 * w) * (r + 1) - w)) by (unfold w, beta; interval with (i_bisect r, i_prec 60)).
    assert (0 < - (r + 1 + w) * - ((r + 1) ^ 2 + (1 + 3 * w) * (r + 1) - w)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < 2 * (r + 1) ^ 2) by (assert (0 < (r + 1) ^ 2) by (apply pow2_gt_0; lra); lra).
    assert (N : 0 < (w + 1) ^ 2 - kappa_at beta r) by nra.
    assert (O := proj2 (proj2 (arcs w r ltac:(lra) ltac:(lra) ltac:(lra)) (or_intror (or_intror H)))); rewrite squared in O.
    apply above_one; lra.
Qed.

(** 4 η κ by the reciprocal of r + 1. *)
Lemma product_by_reciprocal (r : R) : r < - 1 ->
  4 * (eta_at beta r * kappa_at beta r) = 1 + / (r + 1) * (- 2 * beta + 2 * beta ^ 2 * (/ (r + 1)) ^ 2 - beta ^ 2 * (/ (r + 1)) ^ 3).
Proof. intros H; rewrite product_at by lra; field; lra. Qed.

Lemma error_20_is (r : R) : r < - 1 -> 0 <= eta_at beta r * kappa_at beta r ->
  error_20 r = sqrt (1 + / (r + 1) * (- 2 * beta + 2 * beta ^ 2 * (/ (r + 1)) ^ 2 - beta ^ 2 * (/ (r + 1)) ^ 3)) - 1.
Proof.
  intros H N; rewrite <- product_by_reciprocal by exact H; unfold error_20.
  assert (F : sqrt 4 = 2) by (replace 4 with (2 * 2) by ring; apply sqrt_square; lra).
  rewrite (sqrt_mult_alt 4) by lra; now rewrite F.
Qed.

(** Claim Z5, eq 20: on its arc, from the cusp on, its error lies between 0 and 0.3625943, and reaches 0.3625942 at the cusp. *)
Theorem Z5_20 : exists q, is_cusp q /\ 3625942 / 10000000 < error_20 q /\ forall r, r <= q -> 0 < error_20 r < 3625943 / 10000000.
Proof.
  destruct cusp_enclosed as (q & C & Q); exists q; split; [exact C|].
  assert (T : forall r, r <= q -> - 4170 / 10000 <= / (r + 1) < 0).
  { intros r L; split; [|apply Rinv_lt_0_compat; lra].
    apply Ropp_le_cancel; rewrite <- Rinv_opp; apply Rle_trans with (/ (23981 / 10000)); [apply Rinv_le_contravar; lra | lra]. }
  assert (E : forall r, r <= q -> 0 <= eta_at beta r * kappa_at beta r).
  { intros r L; apply (Rmult_le_reg_l 4); [lra|]; rewrite Rmult_0_r, product_by_reciprocal by lra.
    pose proof (T r L) as [T1 T2]; set (t := / (r + 1)) in *; assert (t <= 0) by lra; unfold beta; interval with (i_bisect t, i_prec 60). }
  split.
  - rewrite error_20_is by (try apply E; lra); unfold beta; interval with (i_prec 60).
  - intros r L; rewrite error_20_is by (try apply E; lra).
    assert (B : / (q + 1) <= / (r + 1)).
    { apply Ropp_le_cancel; rewrite <- !Rinv_opp; apply Rinv_le_contravar; lra. }
    assert (B' : - 4169933 / 10000000 <= / (r + 1)) by (apply Rle_trans with (2 := B); interval with (i_prec 60)).
    pose proof (T r L) as [_ T2]; set (t := / (r + 1)) in *; assert (t <= 0) by lra; split.
    + assert (N : 0 < - (- 2 * beta + 2 * beta ^ 2 * t ^ 2 - beta ^ 2 * t ^ 3)) by (unfold beta; interval with (i_bisect t, i_prec 60)).
      apply Rlt_Rminus; rewrite <- sqrt_1 at 1; apply sqrt_lt_1_alt; split; [lra|]; nra.
    + unfold beta; interval with (i_bisect t, i_autodiff t, i_prec 60).
Qed.

(** Claim Z5: at the normal stress of the corner of eqs 16 and 20 the error of eq 20 lies between 0.2521329 and 0.252133. *)
Theorem Z5_corner : exists r, r < - 1 - w /\ kappa_at beta r = (w + 1) ^ 2 /\ 2521329 / 10000000 < error_20 r < 252133 / 1000000.
Proof.
  destruct (IVT (fun r => - ((r + 1) ^ 2 + (1 + 3 * w) * (r + 1) - w)) (- 5923014092 / 1000000000) (- 5923014091 / 1000000000))
    as (r & R & Z).
  - reg.
  - lra.
  - unfold w, beta; interval with (i_prec 60).
  - unfold w, beta; interval with (i_prec 60).
  - exists r; split; [assert (w < 2) by (unfold w, beta; interval with (i_prec 60)); lra|]; split.
    + assert (F : 2 * (r + 1) ^ 2 * ((w + 1) ^ 2 - kappa_at beta r) = (r + 1 + w) * ((r + 1) ^ 2 + (1 + 3 * w) * (r + 1) - w)).
      { rewrite <- squared; unfold kappa_at; field; lra. }
      replace ((r + 1) ^ 2 + (1 + 3 * w) * (r + 1) - w) with 0 in F by lra; rewrite Rmult_0_r in F.
      apply Rmult_integral in F; assert (0 < (r + 1) ^ 2) by (apply pow2_gt_0; lra); destruct F; lra.
    + unfold error_20, eta_at, kappa_at, beta; split; interval with (i_prec 60).
Qed.
