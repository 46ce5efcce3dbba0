(** Cubics with real coefficients: their real root, the sign of the discriminant, and the Routh-Hurwitz criterion
    over the complex numbers. *)

From Slipmode Require Export Functions.

Definition cubic (a b c d s : R) : R := a * s ^ 3 + b * s ^ 2 + c * s + d.

Definition complex_cubic (a b c d : R) (z : C) : C :=
  (RtoC a * z * z * z + RtoC b * z * z + RtoC c * z + RtoC d)%C.

Definition discriminant (a b c d : R) : R :=
  18 * a * b * c * d - 4 * b ^ 3 * d + b ^ 2 * c ^ 2 - 4 * a * c ^ 3 - 27 * a ^ 2 * d ^ 2.

(** ** A real root *)

Theorem real_root (a b c d : R) : a <> 0 -> exists r, cubic a b c d r = 0.
Proof.
  assert (P : forall a b c d, 0 < a -> exists r, cubic a b c d r = 0).
  { clear; intros a b c d A.
    destruct (far [d; c; b; a] 0) as (x & X & PX); [simpl; lra|].
    destruct (far_negative [d; - c; b; - a] 0) as (y & Y & PY); [simpl; lra|].
    destruct (root_inside (cubic a b c d) [d; c; b; a] (- y) x) as (r & _ & _ & E).
    - intros s; unfold cubic; simpl; ring.
    - lra.
    - right; unfold cubic; simpl in PX, PY; split; [apply Rle_lt_trans with (2 := PY) | apply Rlt_le_trans with (1 := PX)];
        apply Req_le; ring.
    - now exists r. }
  intros N; destruct (Rdichotomy _ _ N) as [L|L]; [|now apply P].
  destruct (P (- a) (- b) (- c) (- d)) as [r E]; [lra|].
  exists r; unfold cubic in *; lra.
Qed.

Lemma negative_root (a b c d : R) : 0 < a -> 0 < d -> exists r, r < 0 /\ cubic a b c d r = 0.
Proof.
  intros A D; apply (root_below (cubic a b c d) [d; c; b; a] [d; - c; b; - a]).
  - intros s; unfold cubic; simpl; ring.
  - intros s; simpl; ring.
  - left; unfold cubic; simpl; lra.
Qed.

(** The other factor at a root r. *)
Lemma factor (a b c d r s : R) :
  cubic a b c d r = 0 ->
  cubic a b c d s = (s - r) * (a * s ^ 2 + (b + a * r) * s + (c + b * r + a * r ^ 2)).
Proof.
  intros E; replace (cubic a b c d s) with (cubic a b c d s - cubic a b c d r) by lra; unfold cubic; ring.
Qed.

Lemma discriminant_at_root (a b c d r : R) :
  cubic a b c d r = 0 ->
  discriminant a b c d =
    ((b + a * r) ^ 2 - 4 * a * (c + b * r + a * r ^ 2)) *
    (a * r ^ 2 + (b + a * r) * r + (c + b * r + a * r ^ 2)) ^ 2.
Proof.
  unfold cubic; intros E; assert (D : d = - (a * r ^ 3 + b * r ^ 2 + c * r)) by lra.
  rewrite D; unfold discriminant; ring.
Qed.

(** ** The sign of the discriminant *)

Theorem three_real_roots (a b c d : R) :
  a <> 0 ->
  (0 < discriminant a b c d <->
   exists r s t, r <> s /\ s <> t /\ t <> r /\
     cubic a b c d r = 0 /\ cubic a b c d s = 0 /\ cubic a b c d t = 0).
Proof.
  intros A; split.
  - intros D; destruct (real_root a b c d A) as [r E].
    rewrite (discriminant_at_root a b c d r E) in D.
    set (B := b + a * r) in *; set (Q := c + b * r + a * r ^ 2) in *.
    assert (N : a * r ^ 2 + B * r + Q <> 0) by (intros N; rewrite N in D; lra).
    assert (W : 0 < B ^ 2 - 4 * a * Q).
    { assert (0 < (a * r ^ 2 + B * r + Q) ^ 2) by (apply pow2_gt_0; exact N).
      apply (Rmult_lt_reg_r ((a * r ^ 2 + B * r + Q) ^ 2)); lra. }
    set (w := sqrt (B ^ 2 - 4 * a * Q)).
    assert (WW : w ^ 2 = B ^ 2 - 4 * a * Q) by (apply root_squared; lra).
    assert (W0 : 0 < w) by (now apply sqrt_lt_R0).
    assert (Z : forall s, a * s ^ 2 + B * s + Q = 0 -> cubic a b c d s = 0 /\ s <> r).
    { intros s H; split; [rewrite (factor a b c d r s E); fold B Q; rewrite H; ring|].
      intros ->; contradiction. }
    assert (Z1 : a * ((- B + w) / (2 * a)) ^ 2 + B * ((- B + w) / (2 * a)) + Q = 0).
    { replace (a * ((- B + w) / (2 * a)) ^ 2 + B * ((- B + w) / (2 * a)) + Q)
        with ((w ^ 2 - (B ^ 2 - 4 * a * Q)) / (4 * a)) by (field; exact A).
      rewrite WW; field; exact A. }
    assert (Z2 : a * ((- B - w) / (2 * a)) ^ 2 + B * ((- B - w) / (2 * a)) + Q = 0).
    { replace (a * ((- B - w) / (2 * a)) ^ 2 + B * ((- B - w) / (2 * a)) + Q)
        with ((w ^ 2 - (B ^ 2 - 4 * a * Q)) / (4 * a)) by (field; exact A).
      rewrite WW; field; exact A. }
    destruct (Z _ Z1) as [E1 N1]; destruct (Z _ Z2) as [E2 N2].
    exists r, ((- B + w) / (2 * a)), ((- B - w) / (2 * a)); repeat split; auto.
    intros H; assert (H' : 2 * w / (2 * a) = 0).
    { replace (2 * w / (2 * a)) with ((- B + w) / (2 * a) - (- B - w) / (2 * a)) by (field; exact A); lra. }
    assert (w = 0); [|lra].
    replace w with (2 * w / (2 * a) * a) by (field; exact A); rewrite H'; ring.
  - intros (r & s & t & RS & ST & TR & ER & ES & ET).
    rewrite (discriminant_at_root a b c d r ER).
    rewrite (factor a b c d r s ER) in ES; rewrite (factor a b c d r t ER) in ET.
    set (B := b + a * r) in *; set (Q := c + b * r + a * r ^ 2) in *.
    apply Rmult_integral in ES; destruct ES as [ES|ES]; [lra|].
    apply Rmult_integral in ET; destruct ET as [ET|ET]; [lra|].
    assert (HB : B = - a * (s + t)).
    { apply (Rmult_eq_reg_r (s - t)); [|lra].
      replace (B * (s - t)) with ((a * s ^ 2 + B * s + Q) - (a * t ^ 2 + B * t + Q) - a * (s ^ 2 - t ^ 2)) by ring.
      rewrite ES, ET; ring. }
    assert (HQ : Q = a * s * t).
    { replace Q with ((a * s ^ 2 + B * s + Q) - a * s ^ 2 - B * s) by ring; rewrite ES, HB; ring. }
    rewrite HB, HQ.
    replace (((- a * (s + t)) ^ 2 - 4 * a * (a * s * t)) * (a * r ^ 2 + - a * (s + t) * r + a * s * t) ^ 2)
      with ((a * (s - t)) ^ 2 * (a * (r - s) * (r - t)) ^ 2) by ring.
    apply Rmult_lt_0_compat; apply pow2_gt_0.
    + apply Rmult_integral_contrapositive_currified; lra.
    + repeat apply Rmult_integral_contrapositive_currified; lra.
Qed.

(** A pair x ± iy beside the root r. *)
Lemma discriminant_of_pair (a b c d r x y : R) :
  a <> 0 -> y <> 0 -> cubic a b c d r = 0 ->
  b + a * r = - 2 * a * x -> c + b * r + a * r ^ 2 = a * (x ^ 2 + y ^ 2) -> discriminant a b c d < 0.
Proof.
  intros A Y E HB HQ; rewrite (discriminant_at_root a b c d r E), HB, HQ.
  replace (((- 2 * a * x) ^ 2 - 4 * a * (a * (x ^ 2 + y ^ 2))) *
           (a * r ^ 2 + - 2 * a * x * r + a * (x ^ 2 + y ^ 2)) ^ 2)
    with (- ((2 * a * y) ^ 2 * (a * ((r - x) ^ 2 + y ^ 2)) ^ 2)) by ring.
  apply Ropp_lt_gt_0_contravar, Rmult_lt_0_compat; apply pow2_gt_0.
  - apply Rmult_integral_contrapositive_currified; lra.
  - apply Rmult_integral_contrapositive_currified; [exact A|].
    assert (0 < y ^ 2) by (now apply pow2_gt_0); pose proof (pow2_ge_0 (r - x)); lra.
Qed.

Lemma pair_of_discriminant (a b c d : R) :
  a <> 0 -> discriminant a b c d < 0 ->
  exists r x y, y <> 0 /\ cubic a b c d r = 0 /\
    b + a * r = - 2 * a * x /\ c + b * r + a * r ^ 2 = a * (x ^ 2 + y ^ 2).
Proof.
  intros A D; destruct (real_root a b c d A) as [r E].
  rewrite (discriminant_at_root a b c d r E) in D.
  set (B := b + a * r) in *; set (Q := c + b * r + a * r ^ 2) in *.
  assert (W : 0 < 4 * a * Q - B ^ 2).
  { destruct (Rlt_le_dec 0 (4 * a * Q - B ^ 2)) as [|L]; [assumption|]; exfalso.
    assert (0 <= (B ^ 2 - 4 * a * Q) * (a * r ^ 2 + B * r + Q) ^ 2); [|lra].
    apply Rmult_le_pos; [lra | apply pow2_ge_0]. }
  exists r, (- B / (2 * a)), (sqrt (4 * a * Q - B ^ 2) / (2 * a)).
  fold B Q; split; [|split; [exact E | split; [field; exact A|]]].
  - apply Rmult_integral_contrapositive_currified; [|apply Rinv_neq_0_compat; lra].
    apply Rgt_not_eq, sqrt_lt_R0, W.
  - assert (WW : sqrt (4 * a * Q - B ^ 2) ^ 2 = 4 * a * Q - B ^ 2) by (apply root_squared; lra).
    replace (a * ((- B / (2 * a)) ^ 2 + (sqrt (4 * a * Q - B ^ 2) / (2 * a)) ^ 2))
      with ((B ^ 2 + sqrt (4 * a * Q - B ^ 2) ^ 2) / (4 * a)) by (field; exact A).
    rewrite WW; field; exact A.
Qed.

Theorem complex_pair (a b c d : R) :
  a <> 0 ->
  (discriminant a b c d < 0 <->
   exists r x y, y <> 0 /\ forall s, cubic a b c d s = a * (s - r) * ((s - x) ^ 2 + y ^ 2)).
Proof.
  intros A; split.
  - intros D; destruct (pair_of_discriminant a b c d A D) as (r & x & y & Y & E & HB & HQ).
    exists r, x, y; split; [exact Y|]; intros s; rewrite (factor a b c d r s E), HB, HQ; ring.
  - intros (r & x & y & Y & F).
    assert (E : cubic a b c d r = 0) by (rewrite F; ring).
    pose proof (F (r + 1)) as F1; pose proof (F (r - 1)) as F2; pose proof (F (r + 2)) as F3.
    rewrite (factor a b c d r _ E) in F1; rewrite (factor a b c d r _ E) in F2; rewrite (factor a b c d r _ E) in F3.
    assert (HB : b + a * r = - 2 * a * x) by lra.
    assert (HQ : c + b * r + a * r ^ 2 = a * (x ^ 2 + y ^ 2)) by (rewrite HB in F1; lra).
    exact (discriminant_of_pair a b c d r x y A Y E HB HQ).
Qed.

(** ** Roots over the complex numbers *)

Lemma integral (z w : C) : (z * w = 0)%C -> z = 0%C \/ w = 0%C.
Proof.
  intros E; destruct z as [x y], w as [u v].
  assert (E1 : x * u - y * v = 0) by exact (f_equal fst E).
  assert (E2 : x * v + y * u = 0) by exact (f_equal snd E).
  assert (U : u * (x ^ 2 + y ^ 2) = 0).
  { replace (u * (x ^ 2 + y ^ 2)) with (x * (x * u - y * v) + y * (x * v + y * u)) by ring; rewrite E1, E2; ring. }
  assert (V : v * (x ^ 2 + y ^ 2) = 0).
  { replace (v * (x ^ 2 + y ^ 2)) with (x * (x * v + y * u) - y * (x * u - y * v)) by ring; rewrite E1, E2; ring. }
  destruct (Req_dec (x ^ 2 + y ^ 2) 0) as [N|N].
  - left; assert (x = 0) by nra; assert (y = 0) by nra; now subst.
  - right; apply Rmult_integral in U; apply Rmult_integral in V.
    destruct U as [->|U]; [|contradiction]; destruct V as [->|V]; [reflexivity | contradiction].
Qed.

Definition quadratic (a b c : R) (z : C) : C := (RtoC a * z * z + RtoC b * z + RtoC c)%C.

Lemma complex_factor (a b c d r : R) (z : C) :
  cubic a b c d r = 0 ->
  complex_cubic a b c d z = ((z - RtoC r) * quadratic a (b + a * r) (c + b * r + a * r ^ 2) z)%C.
Proof.
  unfold cubic; intros E; assert (D : d = - (a * r ^ 3 + b * r ^ 2 + c * r)) by lra.
  rewrite D; destruct z as [x y]; unfold complex_cubic, quadratic; project; ring.
Qed.

Lemma complex_roots (a b c d r : R) (z : C) :
  cubic a b c d r = 0 ->
  (complex_cubic a b c d z = 0%C <-> z = RtoC r \/ quadratic a (b + a * r) (c + b * r + a * r ^ 2) z = 0%C).
Proof.
  intros E; rewrite (complex_factor a b c d r z E); split.
  - intros H; apply integral in H; destruct H as [H|H]; [left|now right].
    replace z with (z - RtoC r + RtoC r)%C by ring; rewrite H; ring.
  - intros [->|H]; [|rewrite H]; ring.
Qed.

(** The two real equations of a root of a quadratic. *)
Lemma quadratic_parts (a b c x y : R) :
  quadratic a b c (x, y) = 0%C <-> a * (x ^ 2 - y ^ 2) + b * x + c = 0 /\ y * (2 * a * x + b) = 0.
Proof.
  unfold quadratic; split.
  - intros H; pose proof (f_equal fst H) as H1; pose proof (f_equal snd H) as H2; simpl in H1, H2; split; lra.
  - intros [H1 H2]; project; simpl in *; lra.
Qed.

(** A root with the larger real part. *)
Lemma quadratic_root (a b c : R) :
  0 < a -> exists x y, quadratic a b c (x, y) = 0%C /\ - b <= 2 * a * x /\
    (4 * a * c <= b ^ 2 -> (2 * a * x + b) ^ 2 = b ^ 2 - 4 * a * c) /\ (b ^ 2 < 4 * a * c -> 2 * a * x = - b).
Proof.
  intros A; destruct (Rle_lt_dec (4 * a * c) (b ^ 2)) as [D|D].
  - set (w := sqrt (b ^ 2 - 4 * a * c)).
    assert (W : w ^ 2 = b ^ 2 - 4 * a * c) by (apply root_squared; lra).
    assert (W0 : 0 <= w) by apply sqrt_pos.
    exists ((- b + w) / (2 * a)), 0.
    assert (X : 2 * a * ((- b + w) / (2 * a)) = - b + w) by (field; lra).
    split; [apply quadratic_parts; split; [|ring]|split; [lra|split; intros; [|lra]]].
    + replace (a * (((- b + w) / (2 * a)) ^ 2 - 0 ^ 2) + b * ((- b + w) / (2 * a)) + c)
        with ((w ^ 2 - (b ^ 2 - 4 * a * c)) / (4 * a)) by (field; lra).
      rewrite W; field; lra.
    + rewrite X; replace (- b + w + b) with w by ring; exact W.
  - set (w := sqrt (4 * a * c - b ^ 2)).
    assert (W : w ^ 2 = 4 * a * c - b ^ 2) by (apply root_squared; lra).
    exists (- b / (2 * a)), (w / (2 * a)).
    assert (X : 2 * a * (- b / (2 * a)) = - b) by (field; lra).
    split; [apply quadratic_parts; split; [|rewrite X; ring]|split; [lra|split; intros; lra]].
    replace (a * ((- b / (2 * a)) ^ 2 - (w / (2 * a)) ^ 2) + b * (- b / (2 * a)) + c)
      with ((4 * a * c - b ^ 2 - w ^ 2) / (4 * a)) by (field; lra).
    rewrite W; field; lra.
Qed.

(** ** Routh-Hurwitz for degree 3 *)

Definition stable (a b c d : R) : Prop := forall z, complex_cubic a b c d z = 0%C -> fst z < 0.

Lemma quadratic_stable (a b c : R) :
  0 < a -> ((forall z, quadratic a b c z = 0%C -> fst z < 0) <-> 0 < b /\ 0 < c).
Proof.
  intros A; split.
  - intros S; destruct (quadratic_root a b c A) as (x & y & E & L & R & I).
    specialize (S _ E); simpl in S; assert (B : 0 < b) by nra; split; [exact B|].
    assert (AC : 0 < a * c).
    { destruct (Rle_lt_dec (4 * a * c) (b ^ 2)) as [D|D]; [specialize (R D)|pose proof (pow2_ge_0 b); lra].
      assert (X : 2 * a * x < 0) by nra.
      assert ((2 * a * x + b) ^ 2 < b ^ 2) by nra; lra. }
    destruct (Rlt_le_dec 0 c) as [|M]; [assumption|]; exfalso; nra.
  - intros [B D] [x y] E; apply quadratic_parts in E; destruct E as [E1 E2]; simpl.
    apply Rmult_integral in E2; destruct E2 as [->|E2]; [|nra].
    destruct (Rlt_le_dec x 0) as [|L]; [assumption|]; exfalso.
    assert (0 <= a * x ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
    assert (0 <= b * x) by (apply Rmult_le_pos; lra); lra.
Qed.

Theorem routh_hurwitz (a b c d : R) :
  0 < a -> (stable a b c d <-> 0 < b /\ 0 < d /\ a * d < b * c).
Proof.
  intros A; destruct (real_root a b c d ltac:(lra)) as [r E].
  set (B := b + a * r); set (Q := c + b * r + a * r ^ 2).
  assert (S : stable a b c d <-> r < 0 /\ 0 < B /\ 0 < Q).
  { split.
    - intros S; split; [apply (S (RtoC r)); apply (complex_roots a b c d r _ E); now left|].
      apply (quadratic_stable a B Q A); intros z Z; apply S, (complex_roots a b c d r _ E); now right.
    - intros (N & P) z Z; apply (complex_roots a b c d r _ E) in Z; destruct Z as [->|Z]; [exact N|].
      now apply (quadratic_stable a B Q A). }
  assert (HD : d = - r * Q) by (unfold Q; unfold cubic in E; lra).
  assert (H : b * c - a * d = B * (c + a * r ^ 2)) by (rewrite HD; unfold B, Q; ring).
  rewrite S; split.
  - intros (N & PB & PQ); split; [unfold B in PB; nra|]; split; [rewrite HD; nra|].
    assert (0 < c + a * r ^ 2).
    { replace (c + a * r ^ 2) with (Q - r * B + a * r ^ 2) by (unfold B, Q; ring).
      assert (0 <= a * r ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]); nra. }
    nra.
  - intros (PB & PD & P).
    assert (PC : 0 < c) by (assert (0 < a * d) by nra; destruct (Rlt_le_dec 0 c); [assumption | nra]).
    assert (N : r < 0).
    { destruct (Rlt_le_dec r 0) as [|L]; [assumption|]; exfalso; unfold cubic in E.
      assert (0 <= a * r ^ 3) by (apply Rmult_le_pos; [lra | now apply pow_le]).
      assert (0 <= b * r ^ 2) by (apply Rmult_le_pos; [lra | now apply pow_le]).
      assert (0 <= c * r) by (apply Rmult_le_pos; lra); lra. }
    assert (0 < c + a * r ^ 2).
    { assert (0 <= a * r ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]); lra. }
    split; [exact N|]; split; [|nra].
    destruct (Rlt_le_dec 0 B) as [|L]; [assumption | nra].
Qed.

(** Where a, b and d are positive, the sign of b c - a d decides on which side the other two roots are. *)
Lemma sides (a b c d : R) :
  0 < a -> 0 < b -> 0 < d ->
  ((exists z, complex_cubic a b c d z = 0%C /\ 0 < fst z) <-> b * c < a * d) /\
  ((exists z, complex_cubic a b c d z = 0%C /\ fst z = 0) <-> b * c = a * d).
Proof.
  intros A PB PD; destruct (negative_root a b c d A PD) as (r & N & E).
  set (B := b + a * r); set (Q := c + b * r + a * r ^ 2).
  assert (HD : d = - r * Q) by (unfold Q; unfold cubic in E; lra).
  assert (PQ : 0 < Q) by (destruct (Rlt_le_dec 0 Q); [assumption | nra]).
  assert (H : b * c - a * d = B * (c + a * r ^ 2)) by (rewrite HD; unfold B, Q; ring).
  assert (F : 0 < c + a * r ^ 2).
  { replace (c + a * r ^ 2) with (Q + - r * b) by (unfold Q; ring); nra. }
  assert (Z : forall z, fst z >= 0 -> (complex_cubic a b c d z = 0%C <-> quadratic a B Q z = 0%C)).
  { intros z P; rewrite (complex_roots a b c d r z E); split; [intros [->|Z]; [simpl in P; lra | exact Z]|].
    now right. }
  split.
  - assert (S : b * c < a * d <-> B < 0).
    { split; intros L; [destruct (Rlt_le_dec B 0); [assumption | nra] | nra]. }
    rewrite S; split.
    + intros ([x y] & E1 & P); apply Z in E1; [|simpl in *; lra]; simpl in P.
      apply quadratic_parts in E1; destruct E1 as [E1 E2].
      apply Rmult_integral in E2; destruct E2 as [->|E2]; [|nra].
      destruct (Rlt_le_dec B 0) as [|L]; [assumption|]; exfalso.
      assert (0 <= a * x ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
      assert (0 <= B * x) by (apply Rmult_le_pos; lra); lra.
    + intros L; destruct (quadratic_root a B Q A) as (x & y & E1 & L1 & _).
      assert (0 < x) by nra; exists (x, y); split; [apply Z; [simpl; lra | exact E1] | exact H0].
  - assert (S : b * c = a * d <-> B = 0).
    { split; intros L; [|rewrite L in H; lra].
      apply (Rmult_eq_reg_r (c + a * r ^ 2)); lra. }
    rewrite S; split.
    + intros ([x y] & E1 & P); apply Z in E1; [|simpl in *; lra]; simpl in P; subst x.
      apply quadratic_parts in E1; destruct E1 as [E1 E2].
      assert (Y : y <> 0) by (intros ->; lra).
      apply Rmult_integral in E2; destruct E2 as [E2|E2]; lra.
    + intros L; exists (0, sqrt (Q / a)); split; [|reflexivity].
      assert (W : sqrt (Q / a) ^ 2 = Q / a) by (apply root_squared; left; now apply Rdiv_lt_0_compat).
      apply Z; [simpl; lra|]; apply quadratic_parts; rewrite L; split; [|ring].
      replace (a * (0 ^ 2 - sqrt (Q / a) ^ 2) + 0 * 0 + Q) with (Q - a * sqrt (Q / a) ^ 2) by ring.
      rewrite W; field; lra.
Qed.

(** A root that is not real exists exactly where the discriminant is negative. *)
Theorem oscillating_root (a b c d : R) :
  a <> 0 -> ((exists z, complex_cubic a b c d z = 0%C /\ snd z <> 0) <-> discriminant a b c d < 0).
Proof.
  intros A; split.
  - destruct (real_root a b c d A) as [r E].
    intros ([x y] & H & Y); apply (complex_roots a b c d r _ E) in H; simpl in Y; destruct H as [H|H].
    { apply (f_equal snd) in H; contradiction. }
    apply quadratic_parts in H; destruct H as [H1 H2].
    apply Rmult_integral in H2; destruct H2 as [H2|H2]; [contradiction|].
    assert (HB : b + a * r = - 2 * a * x) by lra.
    apply (discriminant_of_pair a b c d r x y A Y E HB); rewrite HB in H1; lra.
  - intros D; destruct (pair_of_discriminant a b c d A D) as (r & x & y & Y & E & HB & HQ).
    exists (x, y); split; [|exact Y].
    apply (complex_roots a b c d r _ E); right; apply quadratic_parts; rewrite HB, HQ; split; ring.
Qed.

(** Two roots are equal exactly where the discriminant is zero. *)
Theorem double_root (a b c d : R) :
  a <> 0 -> (discriminant a b c d = 0 <-> exists r, cubic a b c d r = 0 /\ 3 * a * r ^ 2 + 2 * b * r + c = 0).
Proof.
  intros A; split.
  - destruct (real_root a b c d A) as [r E]; rewrite (discriminant_at_root a b c d r E); intros H.
    apply Rmult_integral in H; destruct H as [H|H].
    + exists (- (b + a * r) / (2 * a)); rewrite (factor a b c d r _ E); split.
      * replace (a * (- (b + a * r) / (2 * a)) ^ 2 + (b + a * r) * (- (b + a * r) / (2 * a)) + (c + b * r + a * r ^ 2))
          with (- ((b + a * r) ^ 2 - 4 * a * (c + b * r + a * r ^ 2)) / (4 * a)) by (field; exact A).
        rewrite H; field; exact A.
      * replace (3 * a * (- (b + a * r) / (2 * a)) ^ 2 + 2 * b * (- (b + a * r) / (2 * a)) + c)
          with (- ((b + a * r) ^ 2 - 4 * a * (c + b * r + a * r ^ 2)) / (4 * a)) by (field; exact A).
        rewrite H; field; exact A.
    + exists r; split; [exact E|].
      replace ((a * r ^ 2 + (b + a * r) * r + (c + b * r + a * r ^ 2)) ^ 2)
        with ((3 * a * r ^ 2 + 2 * b * r + c) * (3 * a * r ^ 2 + 2 * b * r + c)) in H by ring.
      apply Rmult_integral in H; destruct H; assumption.
  - intros (r & E & H); rewrite (discriminant_at_root a b c d r E).
    replace (a * r ^ 2 + (b + a * r) * r + (c + b * r + a * r ^ 2)) with (3 * a * r ^ 2 + 2 * b * r + c) by ring.
    rewrite H; ring.
Qed.

Definition real_roots (a b c d : R) : Prop := forall z, complex_cubic a b c d z = 0%C -> snd z = 0.

Definition unstable (a b c d : R) : Prop := exists z, complex_cubic a b c d z = 0%C /\ 0 < fst z.

(** All three roots are real exactly where the discriminant is not negative. *)
Theorem real_roots_by_discriminant (a b c d : R) : a <> 0 -> (real_roots a b c d <-> 0 <= discriminant a b c d).
Proof.
  intros A; pose proof (oscillating_root a b c d A) as O; split.
  - intros S; destruct (Rle_lt_dec 0 (discriminant a b c d)) as [|L]; [assumption|]; exfalso.
    apply O in L; destruct L as (z & Z & N); exact (N (S z Z)).
  - intros P z Z; destruct (Req_dec (snd z) 0) as [|N]; [assumption|]; exfalso.
    assert (discriminant a b c d < 0) by (apply O; eauto); lra.
Qed.

(** Another unit of time and another factor of the equation: the roots are multiplied by l. *)
Lemma scaled (k l f3 f2 f1 f0 : R) (z : C) :
  l <> 0 ->
  complex_cubic (k * f3 / l ^ 3) (k * f2 / l ^ 2) (k * f1 / l) (k * f0) (RtoC l * z)%C =
    (RtoC k * complex_cubic f3 f2 f1 f0 z)%C.
Proof.
  intros L; destruct z as [x y]; unfold complex_cubic; project; field; exact L.
Qed.

Lemma scaled_root (k l f3 f2 f1 f0 : R) (z : C) :
  k <> 0 -> l <> 0 ->
  (complex_cubic (k * f3 / l ^ 3) (k * f2 / l ^ 2) (k * f1 / l) (k * f0) (RtoC l * z)%C = 0%C <->
   complex_cubic f3 f2 f1 f0 z = 0%C).
Proof.
  intros N L; rewrite (scaled k l f3 f2 f1 f0 z L); split; intros H; [|rewrite H; ring].
  apply integral in H; destruct H as [H|H]; [|exact H].
  exfalso; apply N; exact (f_equal fst H).
Qed.

(** A cubic with a negative double root is stable. *)
Lemma double_stable (a b c d r : R) :
  0 < a -> 0 < d -> cubic a b c d r = 0 -> 3 * a * r ^ 2 + 2 * b * r + c = 0 -> r < 0 -> stable a b c d.
Proof.
  intros A D Z S L; apply routh_hurwitz; [exact A|]; unfold cubic in Z.
  set (h := 2 * a * r + b).
  assert (E : c = - 3 * a * r ^ 2 - 2 * b * r) by lra.
  assert (F : d = r ^ 2 * h) by (unfold h; rewrite E in Z; replace d with (0 - (a * r ^ 3 + b * r ^ 2 + (- 3 * a * r ^ 2 - 2 * b * r) * r)) by lra; ring).
  assert (R2 : 0 < r ^ 2) by (apply pow2_gt_0; lra).
  assert (H : 0 < h) by (apply (Rmult_lt_reg_l (r ^ 2)); lra).
  assert (P : 0 < a * - r) by (apply Rmult_lt_0_compat; lra).
  split; [unfold h in H; lra|]; split; [exact D|].
  apply Rminus_gt_0_lt; replace (b * c - a * d) with (2 * h * h * - r + 2 * a * - r * (a * r ^ 2) + 4 * (a * h * r ^ 2))
    by (rewrite F, E; unfold h; ring).
  assert (0 < a * r ^ 2) by (apply Rmult_lt_0_compat; lra); assert (0 < a * h) by (apply Rmult_lt_0_compat; lra).
  assert (0 < h * h) by (apply Rmult_lt_0_compat; lra); assert (0 < h * h * - r) by (apply Rmult_lt_0_compat; lra).
  assert (0 < a * - r * (a * r ^ 2)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < a * h * r ^ 2) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
