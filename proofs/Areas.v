(** The areas of the (V, σ) plane in which eq 8 has only real roots, or not, and is stable, or not: claims B1 and B9 of Im
    and Avouac. *)

From Slipmode Require Export Dimensionless Slider.
From Coq Require Import Ranalysis5.

(** Any two points of a set are joined by a continuous curve in it. *)
Definition joined (A : R -> R -> Prop) : Prop :=
  forall V0 s0 V1 s1, A V0 s0 -> A V1 s1 ->
  exists f g, f 0 = V0 /\ g 0 = s0 /\ f 1 = V1 /\ g 1 = s1 /\
    forall u, 0 <= u <= 1 -> continuous f u /\ continuous g u /\ A (f u) (g u).

(** The point that lies between two others. *)
Definition straight (x y u : R) : R := x + u * (y - x).

Lemma straight_continuous (x y u : R) : continuous (straight x y) u.
Proof. apply (ex_derive_continuous (straight x y)); unfold straight; auto_derive; exact I. Qed.

Lemma straight_above (l x y u : R) : l < x -> l < y -> 0 <= u <= 1 -> l < straight x y u.
Proof.
  intros X Y U; replace (straight x y u) with (l + (1 - u) * (x - l) + u * (y - l)) by (unfold straight; ring).
  assert (0 <= (1 - u) * (x - l)) by (apply Rmult_le_pos; lra).
  destruct (Req_dec u 0) as [->|N]; [lra|].
  assert (0 < u * (y - l)) by (apply Rmult_lt_0_compat; lra); lra.
Qed.

Lemma straight_below (l x y u : R) : x < l -> y < l -> 0 <= u <= 1 -> straight x y u < l.
Proof.
  intros X Y U; pose proof (straight_above (- l) (- x) (- y) u ltac:(lra) ltac:(lra) U) as H.
  unfold straight in *; lra.
Qed.

(** The inside of a hyperbola is convex. *)
Lemma hyperbola (l x y x' y' u : R) :
  0 < l -> 0 < x -> 0 < y -> 0 < x' -> 0 < y' -> l < x * y -> l < x' * y' -> 0 <= u <= 1 ->
  l < straight x x' u * straight y y' u.
Proof.
  intros L X Y X' Y' H H' U.
  assert (G : 2 * l < x * y' + x' * y).
  { assert (P : 0 < x * y') by now apply Rmult_lt_0_compat.
    assert (P' : 0 < x' * y) by now apply Rmult_lt_0_compat.
    assert (Q : l * l < x * y' * (x' * y)).
    { replace (x * y' * (x' * y)) with (x * y * (x' * y')) by ring; apply Rmult_le_0_lt_compat; lra. }
    pose proof (pow2_ge_0 (x * y' - x' * y)); nra. }
  replace (straight x x' u * straight y y' u)
    with ((1 - u) ^ 2 * (x * y) + u * (1 - u) * (x * y' + x' * y) + u ^ 2 * (x' * y')) by (unfold straight; ring).
  assert (E : l = (1 - u) ^ 2 * l + u * (1 - u) * (2 * l) + u ^ 2 * l) by ring.
  assert (A1 : (1 - u) ^ 2 * l <= (1 - u) ^ 2 * (x * y)) by (apply Rmult_le_compat_l; [apply pow2_ge_0 | lra]).
  assert (A2 : u * (1 - u) * (2 * l) <= u * (1 - u) * (x * y' + x' * y))
    by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra]).
  assert (A3 : u ^ 2 * l <= u ^ 2 * (x' * y')) by (apply Rmult_le_compat_l; [apply pow2_ge_0 | lra]).
  destruct (Req_dec u 0) as [->|N]; [lra|].
  assert (u ^ 2 * l < u ^ 2 * (x' * y')) by (apply Rmult_lt_compat_l; [apply pow2_gt_0; exact N | lra]); lra.
Qed.

(** The inside of a parabola is convex. *)
Lemma parabola (s p s' p' u : R) :
  s ^ 2 < 4 * p -> s' ^ 2 < 4 * p' -> 0 <= u <= 1 -> straight s s' u ^ 2 < 4 * straight p p' u.
Proof.
  intros H H' U.
  assert (E : straight s s' u ^ 2 = (1 - u) * s ^ 2 + u * s' ^ 2 - u * (1 - u) * (s - s') ^ 2) by (unfold straight; ring).
  assert (0 <= u * (1 - u) * (s - s') ^ 2) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply pow2_ge_0]).
  pose proof (straight_above 0 (4 * p - s ^ 2) (4 * p' - s' ^ 2) u ltac:(lra) ltac:(lra) U) as A.
  rewrite E; unfold straight in *; lra.
Qed.

Section Areas.

Variables a b D K M : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M).

(** The coefficients of eq 8 in the (V, σ) plane. *)
Let c3 (V sigma : R) := M / sigma.
Let c2 (V sigma : R) := a / V + M * V / (sigma * D).
Let c1 (V sigma : R) := K / sigma + (a - b) / D.
Let c0 (V sigma : R) := K * V / (sigma * D).

(** Eq 9. *)
Let K_c (V sigma : R) := (b - a) * sigma / D * (1 + M * V ^ 2 / (sigma * a * D)).

Let plane (V sigma : R) := 0 < V /\ 0 < sigma.
Let decays (V sigma : R) := stable (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma).
Let grows (V sigma : R) := unstable (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma).

(** max Im(s) = 0. *)
Let still (V sigma : R) := real_roots (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma).

(** The areas (i) to (iv) of fig 1. *)
Let area_i (V sigma : R) := plane V sigma /\ decays V sigma /\ still V sigma.
Let area_ii (V sigma : R) := plane V sigma /\ decays V sigma /\ ~ still V sigma.
Let area_iii (V sigma : R) := plane V sigma /\ grows V sigma /\ ~ still V sigma.
Let area_iv (V sigma : R) := plane V sigma /\ grows V sigma /\ still V sigma.

Let beta := b / a.
Let eta (V sigma : R) := M * V ^ 2 / (sigma * a * D).
Let kappa (sigma : R) := K * D / (a * sigma).

Let beta_pos : 0 < beta.
Proof. unfold beta; pos. Qed.

(** ** The plane by S and P *)

Let signs (V sigma y S P : R) :
  plane V sigma -> parts (eta V sigma) (kappa sigma) beta y S P ->
  (decays V sigma <-> S < 2) /\ (grows V sigma <-> 2 < S) /\ (still V sigma <-> 4 * P <= S ^ 2).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros [v w] T.
  assert (E : 0 < eta V sigma) by (unfold eta; pos).
  assert (Q : 0 < kappa sigma) by (unfold kappa; pos).
  unfold decays, grows, still, c3, c2, c1, c0.
  rewrite (stable_groups a b D K M V sigma), (unstable_groups a b D K M V sigma), (real_groups a b D K M V sigma)
    by assumption.
  split; [|split].
  - exact (stable_by_parts (eta V sigma) (kappa sigma) beta y S P E Q T).
  - exact (growing_by_parts (eta V sigma) (kappa sigma) beta y S P E Q T).
  - exact (real_by_parts (eta V sigma) (kappa sigma) beta y S P E T).
Qed.

(** What a point of the plane has. *)
Let have (V sigma : R) :
  plane V sigma ->
  exists y S P, parts (eta V sigma) (kappa sigma) beta y S P /\ 0 < P - S + 1 /\
    (2 < S <-> P < beta) /\ (S < 2 <-> beta < P) /\
    (decays V sigma <-> S < 2) /\ (grows V sigma <-> 2 < S) /\ (still V sigma <-> 4 * P <= S ^ 2).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros L; pose proof L as [v w].
  assert (E : 0 < eta V sigma) by (unfold eta; pos).
  assert (Q : 0 < kappa sigma) by (unfold kappa; pos).
  destruct (parts_exist (eta V sigma) (kappa sigma) beta E Q beta_pos) as (y & S & P & T).
  exists y, S, P; split; [exact T|]; split; [exact (product_pos _ _ _ _ _ _ E Q T)|].
  destruct (side_by_parts _ _ _ _ _ _ beta_pos T); repeat (split; [assumption|]).
  exact (signs V sigma y S P L T).
Qed.

(** The place with given groups. *)
Let V_of (e k : R) := D * sqrt (e * K / (k * M)).
Let sigma_of (k : R) := K * D / (a * k).

Let place (e k : R) :
  0 < e -> 0 < k -> plane (V_of e k) (sigma_of k) /\ eta (V_of e k) (sigma_of k) = e /\ kappa (sigma_of k) = k.
Proof using a_pos D_pos K_pos M_pos.
  intros E Q; assert (W : 0 < e * K / (k * M)) by pos.
  split; [split; [unfold V_of|unfold sigma_of]; pos|]; split.
  - unfold eta, V_of, sigma_of; rewrite Rpow_mult_distr, root_squared by lra.
    field; repeat split; apply Rgt_not_eq; assumption.
  - unfold kappa, sigma_of; field; repeat split; apply Rgt_not_eq; assumption.
Qed.

Let placed (V sigma : R) : plane V sigma -> V_of (eta V sigma) (kappa sigma) = V /\ sigma_of (kappa sigma) = sigma.
Proof using a_pos D_pos K_pos M_pos.
  intros [v w]; split.
  - unfold V_of, eta, kappa.
    replace (M * V ^ 2 / (sigma * a * D) * K / (K * D / (a * sigma) * M)) with (V / D * (V / D))
      by (field; repeat split; apply Rgt_not_eq; assumption).
    rewrite sqrt_square by (left; pos); field; apply Rgt_not_eq; assumption.
  - unfold sigma_of, kappa; field; repeat split; apply Rgt_not_eq; assumption.
Qed.

(** The groups by S and P. *)
Let y_of (S P : R) := beta * (2 - S) / (P - beta).
Let eta_of (S P : R) := / (2 - S + y_of S P).
Let kappa_of (S P : R) := eta_of S P * (1 + y_of S P) * (P - S + 1).

Let fit (S P : R) := 0 < P - S + 1 /\ (S < 2 /\ beta < P \/ 2 < S /\ P < beta).

Let fits (S P : R) :
  fit S P -> let V := V_of (eta_of S P) (kappa_of S P) in let sigma := sigma_of (kappa_of S P) in
  plane V sigma /\ (decays V sigma <-> S < 2) /\ (grows V sigma <-> 2 < S) /\ (still V sigma <-> 4 * P <= S ^ 2).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros [Q H] V sigma; destruct (parts_of beta S P beta_pos Q H) as (_ & E & T & R).
  destruct (place (eta_of S P) (kappa_of S P) E T) as (L & EE & EK); split; [exact L|].
  apply (signs V sigma (y_of S P) S P L); unfold V, sigma; rewrite EE, EK; exact R.
Qed.

Let by_parts (e k y S P : R) :
  parts e k beta y S P -> P - beta <> 0 -> e = eta_of S P /\ k = kappa_of S P.
Proof.
  intros (Y & R & E & Q) N.
  assert (EY : y = y_of S P) by (unfold y_of; rewrite <- R; field; exact N).
  assert (W : 2 - S + y <> 0) by (intros W; rewrite W in E; lra).
  assert (EE : e = eta_of S P).
  { unfold eta_of; rewrite <- EY; apply (Rmult_eq_reg_r (2 - S + y)); [rewrite E; field; exact W | exact W]. }
  split; [exact EE|]; unfold kappa_of; rewrite <- EY, <- EE; exact Q.
Qed.

(** Curves of S and P are curves in the plane. *)
Let path (A : R -> R -> Prop) (S P : R -> R) (V0 s0 V1 s1 y0 y1 : R) :
  (forall u, 0 <= u <= 1 -> continuous S u /\ continuous P u /\ fit (S u) (P u) /\
     let V := V_of (eta_of (S u) (P u)) (kappa_of (S u) (P u)) in
     let sigma := sigma_of (kappa_of (S u) (P u)) in
     (plane V sigma -> (decays V sigma <-> S u < 2) -> (grows V sigma <-> 2 < S u) ->
      (still V sigma <-> 4 * P u <= S u ^ 2) -> A V sigma)) ->
  plane V0 s0 -> parts (eta V0 s0) (kappa s0) beta y0 (S 0) (P 0) ->
  plane V1 s1 -> parts (eta V1 s1) (kappa s1) beta y1 (S 1) (P 1) ->
  exists f g, f 0 = V0 /\ g 0 = s0 /\ f 1 = V1 /\ g 1 = s1 /\
    forall u, 0 <= u <= 1 -> continuous f u /\ continuous g u /\ A (f u) (g u).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros H L0 T0 L1 T1.
  exists (fun u => V_of (eta_of (S u) (P u)) (kappa_of (S u) (P u))), (fun u => sigma_of (kappa_of (S u) (P u))).
  assert (N : forall u, 0 <= u <= 1 -> P u - beta <> 0).
  { intros u U; destruct (H u U) as (_ & _ & [_ F] & _); lra. }
  destruct (by_parts _ _ _ _ _ T0 (N 0 ltac:(lra))) as [E0 K0].
  destruct (by_parts _ _ _ _ _ T1 (N 1 ltac:(lra))) as [E1 K1].
  rewrite <- E0, <- K0, <- E1, <- K1.
  destruct (placed V0 s0 L0) as [-> ->]; destruct (placed V1 s1 L1) as [-> ->].
  do 4 (split; [reflexivity|]); intros u U; destruct (H u U) as (CS & CP & F & HA).
  destruct (fits (S u) (P u) F) as (L & HD & HG & HS); cbv zeta in HA.
  destruct F as [F1 F2]; destruct (parts_of beta (S u) (P u) beta_pos F1 F2) as (W & EP & KP & _).
  pose proof (N u U) as NU.
  assert (C2 : continuous (fun u => 2 - S u) u) by (apply (continuous_minus (fun _ => 2) S); [apply continuous_const | exact CS]).
  assert (CY : continuous (fun u => y_of (S u) (P u)) u).
  { apply (continuous_mult (fun u => beta * (2 - S u)) (fun u => / (P u - beta))).
    - apply (continuous_mult (fun _ => beta) (fun u => 2 - S u)); [apply continuous_const | exact C2].
    - apply (continuous_comp (fun u => P u - beta) Rinv); [|now apply continuous_Rinv].
      apply (continuous_minus P (fun _ => beta)); [exact CP | apply continuous_const]. }
  assert (CE : continuous (fun u => eta_of (S u) (P u)) u).
  { apply (continuous_comp (fun u => 2 - S u + y_of (S u) (P u)) Rinv); [|apply continuous_Rinv; unfold y_of; lra].
    apply (continuous_plus (fun u => 2 - S u) (fun u => y_of (S u) (P u))); assumption. }
  assert (CK : continuous (fun u => kappa_of (S u) (P u)) u).
  { apply (continuous_mult (fun u => eta_of (S u) (P u) * (1 + y_of (S u) (P u))) (fun u => P u - S u + 1)).
    - apply (continuous_mult (fun u => eta_of (S u) (P u)) (fun u => 1 + y_of (S u) (P u))); [exact CE|].
      apply (continuous_plus (fun _ => 1) (fun u => y_of (S u) (P u))); [apply continuous_const | exact CY].
    - apply (continuous_plus (fun u => P u - S u) (fun _ => 1)); [|apply continuous_const].
      now apply (continuous_minus P S). }
  assert (I : continuous (fun u => / kappa_of (S u) (P u)) u).
  { apply (continuous_comp (fun u => kappa_of (S u) (P u)) Rinv); [exact CK | apply continuous_Rinv, Rgt_not_eq, KP]. }
  split; [|split; [|apply HA; assumption]].
  - apply (continuous_mult (fun _ => D) (fun u => sqrt (eta_of (S u) (P u) * K / (kappa_of (S u) (P u) * M))));
      [apply continuous_const|].
    apply (continuous_comp (fun u => eta_of (S u) (P u) * K / (kappa_of (S u) (P u) * M)) sqrt); [|apply continuous_sqrt].
    apply (continuous_mult (fun u => eta_of (S u) (P u) * K) (fun u => / (kappa_of (S u) (P u) * M))).
    + apply (continuous_mult (fun u => eta_of (S u) (P u)) (fun _ => K)); [exact CE | apply continuous_const].
    + apply (continuous_comp (fun u => kappa_of (S u) (P u) * M) Rinv).
      * apply (continuous_mult (fun u => kappa_of (S u) (P u)) (fun _ => M)); [exact CK | apply continuous_const].
      * apply continuous_Rinv, Rgt_not_eq, Rmult_lt_0_compat; assumption.
  - apply (continuous_mult (fun _ => K * D) (fun u => / (a * kappa_of (S u) (P u)))); [apply continuous_const|].
    apply (continuous_comp (fun u => a * kappa_of (S u) (P u)) Rinv).
    + apply (continuous_mult (fun _ => a) (fun u => kappa_of (S u) (P u))); [apply continuous_const | exact CK].
    + apply continuous_Rinv, Rgt_not_eq, Rmult_lt_0_compat; assumption.
Qed.

(** ** Each area is connected *)

Theorem area_ii_joined : joined area_ii.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros V0 s0 V1 s1 (L0 & G0 & R0) (L1 & G1 & R1).
  destruct (have V0 s0 L0) as (y0 & S0 & P0 & T0 & Q0 & HP0 & HB0 & D0 & _ & W0).
  destruct (have V1 s1 L1) as (y1 & S1 & P1 & T1 & Q1 & HP1 & HB1 & D1 & _ & W1).
  apply D0 in G0; apply D1 in G1; rewrite W0 in R0; rewrite W1 in R1; apply Rnot_le_lt in R0, R1.
  apply (path area_ii (straight S0 S1) (straight P0 P1) V0 s0 V1 s1 y0 y1); try assumption.
  - intros u U; do 2 (split; [apply straight_continuous|]).
    assert (S : straight S0 S1 u < 2) by now apply straight_below.
    assert (P : beta < straight P0 P1 u) by (apply straight_above; [now apply HB0 | now apply HB1 | exact U]).
    assert (N : straight S0 S1 u ^ 2 < 4 * straight P0 P1 u) by now apply parabola.
    split; [split; [pose proof (pow2_ge_0 (straight S0 S1 u - 2)); nra | left; split; assumption]|].
    intros V sigma L HD _ HS; split; [exact L|]; split; [now apply HD | rewrite HS; lra].
  - replace (straight S0 S1 0) with S0 by (unfold straight; ring); replace (straight P0 P1 0) with P0 by (unfold straight; ring); exact T0.
  - replace (straight S0 S1 1) with S1 by (unfold straight; ring); replace (straight P0 P1 1) with P1 by (unfold straight; ring); exact T1.
Qed.

Theorem area_iii_joined : joined area_iii.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros V0 s0 V1 s1 (L0 & G0 & R0) (L1 & G1 & R1).
  destruct (have V0 s0 L0) as (y0 & S0 & P0 & T0 & Q0 & HP0 & HB0 & _ & D0 & W0).
  destruct (have V1 s1 L1) as (y1 & S1 & P1 & T1 & Q1 & HP1 & HB1 & _ & D1 & W1).
  apply D0 in G0; apply D1 in G1; rewrite W0 in R0; rewrite W1 in R1; apply Rnot_le_lt in R0, R1.
  apply (path area_iii (straight S0 S1) (straight P0 P1) V0 s0 V1 s1 y0 y1); try assumption.
  - intros u U; do 2 (split; [apply straight_continuous|]).
    assert (S : 2 < straight S0 S1 u) by now apply straight_above.
    assert (P : straight P0 P1 u < beta) by (apply straight_below; [now apply HP0 | now apply HP1 | exact U]).
    assert (N : straight S0 S1 u ^ 2 < 4 * straight P0 P1 u) by now apply parabola.
    split; [split; [pose proof (pow2_ge_0 (straight S0 S1 u - 2)); nra | right; split; assumption]|].
    intros V sigma L _ HG HS; split; [exact L|]; split; [now apply HG | rewrite HS; lra].
  - replace (straight S0 S1 0) with S0 by (unfold straight; ring); replace (straight P0 P1 0) with P0 by (unfold straight; ring); exact T0.
  - replace (straight S0 S1 1) with S1 by (unfold straight; ring); replace (straight P0 P1 1) with P1 by (unfold straight; ring); exact T1.
Qed.

(** Two numbers with a given sum and product. *)
Let numbers (S P : R) : 4 * P <= S ^ 2 -> exists q r, q + r = S /\ q * r = P.
Proof using.
  intros H; assert (W : sqrt (S ^ 2 - 4 * P) ^ 2 = S ^ 2 - 4 * P) by (apply root_squared; lra).
  exists ((S + sqrt (S ^ 2 - 4 * P)) / 2), ((S - sqrt (S ^ 2 - 4 * P)) / 2); split; [field|].
  replace ((S + sqrt (S ^ 2 - 4 * P)) / 2 * ((S - sqrt (S ^ 2 - 4 * P)) / 2))
    with ((S ^ 2 - sqrt (S ^ 2 - 4 * P) ^ 2) / 4) by field.
  rewrite W; field.
Qed.

Let both_negative (S P : R) : 4 * P <= S ^ 2 -> S < 0 -> 0 < P -> exists x y, 0 < x /\ 0 < y /\ - (x + y) = S /\ x * y = P.
Proof using.
  intros H N Q; destruct (numbers S P H) as (q & r & HS & HP); exists (- q), (- r).
  assert (q < 0) by (destruct (Rlt_le_dec q 0) as [|L]; [assumption|]; exfalso; nra).
  assert (r < 0) by (destruct (Rlt_le_dec r 0) as [|L]; [assumption|]; exfalso; nra).
  repeat split; lra.
Qed.

(** For a <= b the two roots are far below −1. *)
Let low (V sigma y S P : R) : a <= b -> area_i V sigma -> parts (eta V sigma) (kappa sigma) beta y S P -> S < 0.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros L (I & G & R) T.
  destruct (signs V sigma y S P I T) as (HD & _ & HS); apply HD in G; apply HS in R.
  assert (B : 1 <= beta).
  { unfold beta; apply (Rmult_le_reg_r a); [exact a_pos|]; replace (b / a * a) with b by (field; lra); lra. }
  assert (beta < P) by (apply (side_by_parts _ _ _ _ _ _ beta_pos T); exact G).
  destruct (Rlt_le_dec S 0) as [|N]; [assumption|]; exfalso; nra.
Qed.

Theorem area_i_joined : a <= b -> joined area_i.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros AB V0 s0 V1 s1 I0 I1; pose proof I0 as (L0 & G0 & R0); pose proof I1 as (L1 & G1 & R1).
  destruct (have V0 s0 L0) as (y0 & S0 & P0 & T0 & Q0 & HP0 & HB0 & D0 & _ & W0).
  destruct (have V1 s1 L1) as (y1 & S1 & P1 & T1 & Q1 & HP1 & HB1 & D1 & _ & W1).
  pose proof (low V0 s0 y0 S0 P0 AB I0 T0) as N0; pose proof (low V1 s1 y1 S1 P1 AB I1 T1) as N1.
  apply D0, HB0 in G0; apply D1, HB1 in G1; apply W0 in R0; apply W1 in R1; pose proof beta_pos as B0.
  destruct (both_negative S0 P0 R0 N0 ltac:(lra)) as (x & z & X & Z & ES & EP).
  destruct (both_negative S1 P1 R1 N1 ltac:(lra)) as (x' & z' & X' & Z' & ES' & EP').
  apply (path area_i (fun u => - (straight x x' u + straight z z' u)) (fun u => straight x x' u * straight z z' u)
           V0 s0 V1 s1 y0 y1); try assumption.
  - intros u U.
    assert (PX : 0 < straight x x' u) by now apply straight_above.
    assert (PZ : 0 < straight z z' u) by now apply straight_above.
    assert (H : beta < straight x x' u * straight z z' u) by (apply hyperbola; lra).
    split; [|split; [|split; [split; [lra | left; lra]|]]].
    + apply (continuous_opp (fun u => straight x x' u + straight z z' u)).
      apply (continuous_plus (straight x x') (straight z z')); apply straight_continuous.
    + apply (continuous_mult (straight x x') (straight z z')); apply straight_continuous.
    + intros V sigma L HD _ HS; split; [exact L|]; split; [apply HD; lra | apply HS].
      pose proof (pow2_ge_0 (straight x x' u - straight z z' u)); lra.
  - replace (- (straight x x' 0 + straight z z' 0)) with S0 by (unfold straight; lra).
    replace (straight x x' 0 * straight z z' 0) with P0 by (unfold straight; lra); exact T0.
  - replace (- (straight x x' 1 + straight z z' 1)) with S1 by (unfold straight; lra).
    replace (straight x x' 1 * straight z z' 1) with P1 by (unfold straight; rewrite <- EP'; ring); exact T1.
Qed.

Let above_one (S P : R) :
  4 * P <= S ^ 2 -> 2 < S -> 0 < P - S + 1 -> exists x y, 0 < x < 1 /\ 0 < y < 1 /\ (x + y) / (x * y) = S /\ / (x * y) = P.
Proof using.
  intros H N Q; destruct (numbers S P H) as (q & r & HS & HP); exists (/ q), (/ r).
  assert (E : 0 < (q - 1) * (r - 1)) by nra.
  assert (1 < q) by (destruct (Rlt_le_dec 1 q) as [|L]; [assumption|]; exfalso; nra).
  assert (1 < r) by (destruct (Rlt_le_dec 1 r) as [|L]; [assumption|]; exfalso; nra).
  assert (I : forall t, 1 < t -> 0 < / t < 1).
  { intros t T; split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_lt_contravar; lra]. }
  split; [now apply I|]; split; [now apply I|]; split; [rewrite <- HS | rewrite <- HP]; field; lra.
Qed.

Theorem area_iv_joined : joined area_iv.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros V0 s0 V1 s1 (L0 & G0 & R0) (L1 & G1 & R1).
  destruct (have V0 s0 L0) as (y0 & S0 & P0 & T0 & Q0 & HP0 & HB0 & _ & D0 & W0).
  destruct (have V1 s1 L1) as (y1 & S1 & P1 & T1 & Q1 & HP1 & HB1 & _ & D1 & W1).
  apply D0 in G0; apply D1 in G1; apply W0 in R0; apply W1 in R1; pose proof beta_pos as B0.
  destruct (above_one S0 P0 R0 G0 Q0) as (x & z & X & Z & ES & EP).
  destruct (above_one S1 P1 R1 G1 Q1) as (x' & z' & X' & Z' & ES' & EP').
  apply HP0 in G0; apply HP1 in G1.
  assert (I : forall p, 0 < p -> / p < beta <-> / beta < p).
  { intros p PP; split; intros L; [rewrite <- (Rinv_inv p) | rewrite <- (Rinv_inv beta)]; apply Rinv_lt_contravar; try assumption;
      apply Rmult_lt_0_compat; try assumption; now apply Rinv_0_lt_compat. }
  apply (path area_iv (fun u => (straight x x' u + straight z z' u) / (straight x x' u * straight z z' u))
           (fun u => / (straight x x' u * straight z z' u)) V0 s0 V1 s1 y0 y1); try assumption.
  - intros u U.
    assert (PX : 0 < straight x x' u) by (apply straight_above; lra).
    assert (PZ : 0 < straight z z' u) by (apply straight_above; lra).
    assert (MX : straight x x' u < 1) by (apply straight_below; lra).
    assert (MZ : straight z z' u < 1) by (apply straight_below; lra).
    assert (PP : 0 < straight x x' u * straight z z' u) by now apply Rmult_lt_0_compat.
    assert (H : / beta < straight x x' u * straight z z' u).
    { apply hyperbola; try lra; [now apply Rinv_0_lt_compat| |]; apply I; try (now rewrite EP || now rewrite EP');
        apply Rmult_lt_0_compat; lra. }
    assert (CX : continuous (fun u => / (straight x x' u * straight z z' u)) u).
    { apply (continuous_comp (fun u => straight x x' u * straight z z' u) Rinv); [|apply continuous_Rinv; lra].
      apply (continuous_mult (straight x x') (straight z z')); apply straight_continuous. }
    set (p := straight x x' u) in *; set (q := straight z z' u) in *.
    split; [|split; [exact CX|split; [split|]]].
    + apply (continuous_mult (fun u => straight x x' u + straight z z' u) (fun u => / (straight x x' u * straight z z' u)));
        [|exact CX].
      apply (continuous_plus (straight x x') (straight z z')); apply straight_continuous.
    + replace (/ (p * q) - (p + q) / (p * q) + 1) with ((1 - p) * (1 - q) / (p * q)) by (field; lra).
      apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | exact PP].
    + right; split; [|now apply I].
      replace ((p + q) / (p * q)) with (2 + (p * (1 - q) + q * (1 - p)) / (p * q)) by (field; lra).
      assert (0 < (p * (1 - q) + q * (1 - p)) / (p * q)); [|lra].
      apply Rdiv_lt_0_compat; [apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; lra | exact PP].
    + intros V sigma L _ HG HS; split; [exact L|]; split; [apply HG | apply HS].
      * replace ((p + q) / (p * q)) with (2 + (p * (1 - q) + q * (1 - p)) / (p * q)) by (field; lra).
        assert (0 < (p * (1 - q) + q * (1 - p)) / (p * q)); [|lra].
        apply Rdiv_lt_0_compat; [apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; lra | exact PP].
      * replace (((p + q) / (p * q)) ^ 2) with (4 * / (p * q) + ((p - q) / (p * q)) ^ 2) by (field; lra).
        pose proof (pow2_ge_0 ((p - q) / (p * q))); lra.
  - replace (straight x x' 0) with x by (unfold straight; ring); replace (straight z z' 0) with z by (unfold straight; ring).
    rewrite ES, EP; exact T0.
  - replace (straight x x' 1) with x' by (unfold straight; ring); replace (straight z z' 1) with z' by (unfold straight; ring).
    rewrite ES', EP'; exact T1.
Qed.

(** ** Each area has a point *)

Let point (A : R -> R -> Prop) (S P : R) :
  fit S P ->
  (forall V sigma, plane V sigma -> (decays V sigma <-> S < 2) -> (grows V sigma <-> 2 < S) ->
     (still V sigma <-> 4 * P <= S ^ 2) -> A V sigma) -> exists V sigma, A V sigma.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros F H; destruct (fits S P F) as (L & D' & G & W); eexists; eexists; exact (H _ _ L D' G W).
Qed.

Theorem area_i_exists : exists V sigma, area_i V sigma.
Proof using a_pos b_pos D_pos K_pos M_pos.
  pose proof beta_pos as B; apply (point area_i (- 2 * (1 + beta)) ((1 + beta) ^ 2)).
  - split; [nra | left; split; nra].
  - intros V sigma L HD _ HS; split; [exact L|]; split; [apply HD; lra | apply HS; lra].
Qed.

Theorem area_ii_exists : exists V sigma, area_ii V sigma.
Proof using a_pos b_pos D_pos K_pos M_pos.
  pose proof beta_pos as B; apply (point area_ii 0 (1 + beta)).
  - split; [lra | left; split; lra].
  - intros V sigma L HD _ HS; split; [exact L|]; split; [apply HD; lra | rewrite HS; lra].
Qed.

Let weakening : a < b -> 1 < beta.
Proof using a_pos.
  intros L; unfold beta; apply (Rmult_lt_reg_r a); [exact a_pos|]; replace (b / a * a) with b by (field; lra); lra.
Qed.

(** A number between 1 and the root of β. *)
Let middle : a < b -> exists q, 1 < q /\ q ^ 2 < beta.
Proof using a_pos.
  intros L; pose proof (weakening L) as B; exists (2 * beta / (1 + beta)); split.
  - apply (Rmult_lt_reg_r (1 + beta)); [lra|]; replace (2 * beta / (1 + beta) * (1 + beta)) with (2 * beta) by (field; lra); lra.
  - apply (Rmult_lt_reg_r ((1 + beta) ^ 2)); [apply pow_lt; lra|].
    replace ((2 * beta / (1 + beta)) ^ 2 * (1 + beta) ^ 2) with (4 * beta * beta) by (field; lra).
    assert (0 < beta * (1 - beta) ^ 2) by (apply Rmult_lt_0_compat; [lra | apply pow2_gt_0; lra]); nra.
Qed.

Theorem area_iii_exists : a < b -> exists V sigma, area_iii V sigma.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros L; destruct (middle L) as (q & Q & H); apply (point area_iii (2 * q) ((q ^ 2 + beta) / 2)).
  - split; [nra | right; split; lra].
  - intros V sigma I _ HG HS; split; [exact I|]; split; [apply HG; lra | rewrite HS; lra].
Qed.

Theorem area_iv_exists : a < b -> exists V sigma, area_iv V sigma.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros L; destruct (middle L) as (q & Q & H); apply (point area_iv (2 * q) (q ^ 2)).
  - split; [nra | right; split; lra].
  - intros V sigma I _ HG HS; split; [exact I|]; split; [apply HG; lra | apply HS; lra].
Qed.

(** ** The claims *)

Let transition (V sigma : R) :
  plane V sigma ->
  (decays V sigma <-> K_c V sigma < K) /\ (grows V sigma <-> K < K_c V sigma) /\ (still V sigma -> K <> K_c V sigma).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros [v w]; pose proof (S1 a b D K M sigma V a_pos D_pos K_pos M_pos w v) as (H1 & H2 & H3).
  split; [exact H1|]; split; [exact H2|]; intros T E; apply H3 in E; destruct E as (z & Z & X).
  assert (Y : snd z = 0) by exact (T z Z).
  assert (F : fst (complex_cubic (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma) z) = 0) by exact (f_equal fst Z).
  destruct z as [x y]; simpl in X, Y; subst x y; unfold complex_cubic in F; simpl in F.
  assert (0 < c0 V sigma) by (unfold c0; pos); lra.
Qed.

(** Claim B1: the points with max Im(s) = 0 are two separate connected areas, a stable and an unstable one. *)
Theorem B1 : a < b ->
  ((exists V sigma, area_i V sigma) /\ joined area_i) /\
  ((exists V sigma, area_iv V sigma) /\ joined area_iv) /\
  (forall V sigma, plane V sigma -> still V sigma -> area_i V sigma \/ area_iv V sigma) /\
  (forall f g, (forall u, 0 <= u <= 1 -> continuous f u /\ continuous g u /\ plane (f u) (g u) /\ still (f u) (g u)) ->
     ~ (area_i (f 0) (g 0) /\ area_iv (f 1) (g 1))).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros L; split; [split; [exact area_i_exists | apply area_i_joined; lra]|].
  split; [split; [exact (area_iv_exists L) | exact area_iv_joined]|]; split.
  - intros V sigma I T; destruct (transition V sigma I) as (HD & HG & N); specialize (N T).
    destruct (Rtotal_order K (K_c V sigma)) as [H|[H|H]].
    + right; split; [exact I | split; [now apply HG | exact T]].
    + contradiction.
    + left; split; [exact I | split; [now apply HD | exact T]].
  - intros f g H [(I0 & D0 & _) (I1 & G1 & _)].
    destruct (IVT_interv (fun u => K_c (f u) (g u) - K) 0 1) as (u & U & E).
    + intros u U; destruct (H u U) as (CF & CG & [v w] & _); apply continuity_pt_filterlim.
      apply (continuous_minus (fun u => K_c (f u) (g u)) (fun _ => K)); [|apply continuous_const].
      unfold K_c.
      apply (continuous_mult (fun u => (b - a) * g u / D) (fun u => 1 + M * f u ^ 2 / (g u * a * D))).
      * apply (continuous_mult (fun u => (b - a) * g u) (fun _ => / D)); [|apply continuous_const].
        apply (continuous_mult (fun _ => b - a) g); [apply continuous_const | exact CG].
      * apply (continuous_plus (fun _ => 1) (fun u => M * f u ^ 2 / (g u * a * D))); [apply continuous_const|].
        apply (continuous_mult (fun u => M * f u ^ 2) (fun u => / (g u * a * D))).
        { apply (continuous_mult (fun _ => M) (fun u => f u ^ 2)); [apply continuous_const|].
          apply (continuous_mult f (fun u => f u * 1)); [exact CF|].
          apply (continuous_mult f (fun _ => 1)); [exact CF | apply continuous_const]. }
        apply (continuous_comp (fun u => g u * a * D) Rinv).
        { apply (continuous_mult (fun u => g u * a) (fun _ => D)); [|apply continuous_const].
          apply (continuous_mult g (fun _ => a)); [exact CG | apply continuous_const]. }
        apply continuous_Rinv, Rgt_not_eq; red; pos.
    + lra.
    + apply (transition _ _ I0) in D0; lra.
    + apply (transition _ _ I1) in G1; lra.
    + destruct (H u U) as (_ & _ & I & T); apply (transition _ _ I) in T; lra.
Qed.

(** Claim B9: of the areas (i) to (iv) all exist for a < b, and (i) and (ii) only otherwise. *)
Theorem B9 :
  (exists V sigma, area_i V sigma) /\ (exists V sigma, area_ii V sigma) /\
  (a < b -> (exists V sigma, area_iii V sigma) /\ (exists V sigma, area_iv V sigma)) /\
  (b <= a -> forall V sigma, ~ area_iii V sigma /\ ~ area_iv V sigma) /\
  (forall V sigma, plane V sigma ->
     area_i V sigma \/ area_ii V sigma \/ area_iii V sigma \/ area_iv V sigma \/ K = K_c V sigma).
Proof using a_pos b_pos D_pos K_pos M_pos.
  split; [exact area_i_exists|]; split; [exact area_ii_exists|].
  split; [intros L; split; [exact (area_iii_exists L) | exact (area_iv_exists L)]|]; split.
  - intros L V sigma; assert (N : forall I : plane V sigma, ~ grows V sigma).
    { intros I G; pose proof I as [v w].
      assert (Z : decays V sigma) by exact (S5 a b D K M sigma V a_pos D_pos K_pos M_pos w v L).
      apply (transition V sigma I) in Z; apply (transition V sigma I) in G; lra. }
    split; intros (I & G & _); exact (N I G).
  - intros V sigma I; destruct (transition V sigma I) as (HD & HG & _).
    assert (W : still V sigma \/ ~ still V sigma) by apply Classical_Prop.classic.
    destruct (Rtotal_order K (K_c V sigma)) as [H|[H|H]]; [apply HG in H | | apply HD in H];
      [destruct W | | destruct W]; unfold area_i, area_ii, area_iii, area_iv; tauto.
Qed.

End Areas.
