(** Where the roots of a real polynomial lie: up to degree 4 when all are left of the imaginary axis, and when one is right of it; up
    to degree 3 when all are real. A polynomial is the list of its coefficients, by ascending power. *)

From Slipmode Require Export Cubics.

Definition at_complex (p : list R) (z : C) : C := fold_right (fun c rest => (RtoC c + z * rest)%C) 0%C p.

(** Every root has a negative real part. The polynomial zero has every number as a root. *)
Definition all_left (p : list R) : Prop := forall z, at_complex p z = 0%C -> fst z < 0.

(** A root has a positive real part. *)
Definition one_right (p : list R) : Prop := exists z, at_complex p z = 0%C /\ 0 < fst z.

(** Every root is real. *)
Definition all_real (p : list R) : Prop := forall z, at_complex p z = 0%C -> snd z = 0.

(** ** The leading coefficient may be zero, and have either sign *)

Lemma no_root_is_zero (p : list R) (z : C) : at_complex (p ++ [0]) z = at_complex p z.
Proof. induction p as [|c p IH]; simpl; [ring | rewrite IH; reflexivity]. Qed.

Lemma at_opposite (p : list R) (z : C) : at_complex (map Ropp p) z = (- at_complex p z)%C.
Proof.
  induction p as [|c p IH]; simpl; [ring|].
  rewrite IH; replace (RtoC (- c)) with (- RtoC c)%C by (now rewrite <- RtoC_opp); ring.
Qed.

Lemma opposite_root (p : list R) (z : C) : at_complex (map Ropp p) z = 0%C <-> at_complex p z = 0%C.
Proof.
  rewrite at_opposite; split; intros E; [|rewrite E; ring].
  replace (at_complex p z) with (- - at_complex p z)%C by ring; rewrite E; ring.
Qed.

Lemma by_leading (S : list R -> Prop) (p : list R) (c : R) (A B L : Prop) :
  (S (map Ropp (p ++ [c])) <-> S (p ++ [c])) -> (S (p ++ [0]) <-> S p) ->
  (0 < c -> (S (p ++ [c]) <-> A)) -> (0 < - c -> (S (map Ropp (p ++ [c])) <-> B)) -> (S p <-> L) ->
  (S (p ++ [c]) <-> (0 < c /\ A) \/ (0 < - c /\ B) \/ (c = 0 /\ L)).
Proof.
  intros O Z P N Low; destruct (Rtotal_order c 0) as [H|[H|H]].
  - rewrite <- O, (N ltac:(lra)); intuition lra.
  - subst c; rewrite Z, Low; intuition lra.
  - rewrite (P H); intuition lra.
Qed.

Lemma left_opposite (p : list R) : all_left (map Ropp p) <-> all_left p.
Proof. split; intros H z E; apply H, opposite_root, E || (apply H; now apply opposite_root). Qed.

Lemma right_opposite (p : list R) : one_right (map Ropp p) <-> one_right p.
Proof. split; intros (z & E & L); exists z; split; auto; now apply opposite_root. Qed.

Lemma left_zero (p : list R) : all_left (p ++ [0]) <-> all_left p.
Proof. split; intros H z E; apply H; [rewrite no_root_is_zero | rewrite <- no_root_is_zero]; exact E. Qed.

Lemma right_zero (p : list R) : one_right (p ++ [0]) <-> one_right p.
Proof.
  split; intros (z & E & L); exists z; split; auto; [rewrite <- no_root_is_zero | rewrite no_root_is_zero]; exact E.
Qed.

(** ** Degree 0 to 2 *)

Lemma left_0 (c : R) : 0 < c -> (all_left [c] <-> True).
Proof.
  intros P; split; [trivial|]; intros _ z E; exfalso.
  apply (f_equal fst) in E; destruct z; simpl in E; lra.
Qed.

Lemma right_0 (c : R) : 0 < c -> (one_right [c] <-> False).
Proof.
  intros P; split; [|contradiction]; intros (z & E & _).
  apply (f_equal fst) in E; destruct z; simpl in E; lra.
Qed.

Lemma linear_root (c0 c1 : R) (z : C) : 0 < c1 -> (at_complex [c0; c1] z = 0%C <-> z = RtoC (- c0 / c1)).
Proof.
  intros P; destruct z as [x y]; split.
  - intros E; pose proof (f_equal fst E) as X; pose proof (f_equal snd E) as Y; simpl in X, Y.
    assert (y = 0) by (apply (Rmult_eq_reg_r c1); lra); subst y; unfold RtoC; f_equal.
    apply (Rmult_eq_reg_r c1); [|lra]; replace (- c0 / c1 * c1) with (- c0) by (field; lra); lra.
  - intros E; inversion E; project; simpl; field; lra.
Qed.

Lemma quotient_negative (a b : R) : 0 < b -> (- a / b < 0 <-> 0 < a).
Proof.
  intros P; assert (E : a = - (- a / b) * b) by (field; lra); split; intros L; [rewrite E|]; nra.
Qed.

Lemma left_1 (c0 c1 : R) : 0 < c1 -> (all_left [c0; c1] <-> 0 < c0).
Proof.
  intros P; rewrite <- (quotient_negative c0 c1 P); split.
  - intros H; apply (H (RtoC (- c0 / c1))), (linear_root c0 c1 _ P); reflexivity.
  - intros H z E; apply (linear_root c0 c1 _ P) in E; subst z; exact H.
Qed.

Lemma right_1 (c0 c1 : R) : 0 < c1 -> (one_right [c0; c1] <-> c0 < 0).
Proof.
  intros P; split.
  - intros (z & E & L); apply (linear_root c0 c1 _ P) in E; subst z; simpl in L.
    assert (E : c0 = - (- c0 / c1) * c1) by (field; lra); nra.
  - intros L; exists (RtoC (- c0 / c1)); split; [now apply (linear_root c0 c1 _ P)|]; simpl.
    apply Rdiv_lt_0_compat; lra.
Qed.

Lemma as_quadratic (c0 c1 c2 : R) (z : C) : at_complex [c0; c1; c2] z = quadratic c2 c1 c0 z.
Proof. unfold quadratic; simpl; ring. Qed.

Lemma left_2 (c0 c1 c2 : R) : 0 < c2 -> (all_left [c0; c1; c2] <-> 0 < c0 /\ 0 < c1).
Proof.
  intros P; pose proof (quadratic_stable c2 c1 c0 P) as S; unfold all_left; setoid_rewrite as_quadratic; tauto.
Qed.

Lemma quadratic_right (a b c : R) :
  0 < a -> ((exists z, quadratic a b c z = 0%C /\ 0 < fst z) <-> b < 0 \/ c < 0).
Proof.
  intros A; split.
  - intros ([x y] & E & L); simpl in L; apply quadratic_parts in E; destruct E as [E1 E2].
    apply Rmult_integral in E2; destruct E2 as [->|E2]; [|left; nra].
    destruct (Rlt_le_dec b 0) as [|B]; [now left|]; right.
    assert (0 < a * x ^ 2) by (apply Rmult_lt_0_compat; [exact A | now apply pow_lt]).
    assert (0 <= b * x) by (apply Rmult_le_pos; lra); lra.
  - intros H; destruct (quadratic_root a b c A) as (x & y & E & L & D & I); exists (x, y); split; [exact E|]; simpl.
    destruct H as [B|N]; [nra|].
    assert (0 < a * - c) by (apply Rmult_lt_0_compat; lra).
    specialize (D ltac:(pose proof (pow2_ge_0 b); lra)).
    assert (Q : b ^ 2 < (2 * a * x + b) ^ 2) by lra.
    assert (T : 0 < 2 * a * x * (2 * a * x + 2 * b)) by lra.
    destruct (Rlt_le_dec 0 x) as [|X]; [assumption|]; exfalso.
    assert (0 <= a * - x) by (apply Rmult_le_pos; lra).
    assert (0 <= a * - x * (2 * a * x + 2 * b)) by (apply Rmult_le_pos; lra); lra.
Qed.

Lemma right_2 (c0 c1 c2 : R) : 0 < c2 -> (one_right [c0; c1; c2] <-> c0 < 0 \/ c1 < 0).
Proof.
  intros P; pose proof (quadratic_right c2 c1 c0 P) as S; unfold one_right; setoid_rewrite as_quadratic; tauto.
Qed.

(** ** Degree 3 *)

Lemma as_cubic (c0 c1 c2 c3 : R) (z : C) : at_complex [c0; c1; c2; c3] z = complex_cubic c3 c2 c1 c0 z.
Proof. unfold complex_cubic; simpl; ring. Qed.

Lemma left_3 (c0 c1 c2 c3 : R) :
  0 < c3 -> (all_left [c0; c1; c2; c3] <-> 0 < c0 /\ 0 < c1 /\ 0 < c2 /\ 0 < c2 * c1 - c3 * c0).
Proof.
  intros P; pose proof (routh_hurwitz c3 c2 c1 c0 P) as S; unfold all_left; setoid_rewrite as_cubic.
  fold (stable c3 c2 c1 c0); rewrite S; split; [|intuition lra]; intros (B & D & H).
  assert (0 < c3 * c0) by (now apply Rmult_lt_0_compat).
  assert (0 < c1) by (destruct (Rlt_le_dec 0 c1); [assumption | nra]); repeat split; lra.
Qed.

(** The factors s + u and s^2 + w s + Q. *)
Lemma signs_3 (u w Q : R) :
  u < 0 \/ w < 0 \/ Q < 0 <-> u * Q < 0 \/ Q + u * w < 0 \/ u + w < 0 \/ w * (u ^ 2 + u * w + Q) < 0.
Proof.
  split.
  - intros H; destruct (Rlt_le_dec (u * Q) 0) as [|C0]; [now left|].
    destruct (Rlt_le_dec (Q + u * w) 0) as [|C1]; [tauto|].
    destruct (Rlt_le_dec (u + w) 0) as [|C2]; [tauto|]; do 3 right.
    assert (U : 0 <= u).
    { destruct (Rle_lt_dec 0 u) as [|L]; [assumption|]; exfalso.
      assert (Q <= 0) by nra; assert (0 < w) by lra; nra. }
    destruct (Rle_lt_dec 0 w) as [W|W].
    + assert (N : Q < 0) by lra; assert (u = 0) by nra; subst u; lra.
    + assert (0 < u) by lra; assert (0 < u * - w) by (apply Rmult_lt_0_compat; lra).
      assert (0 <= u * (u + w)) by (apply Rmult_le_pos; lra).
      assert (0 < - w * (u ^ 2 + u * w + Q)) by (apply Rmult_lt_0_compat; lra); lra.
  - intros H; destruct (Rlt_le_dec u 0) as [|U]; [now left|].
    destruct (Rlt_le_dec w 0) as [|W]; [tauto|]; destruct (Rlt_le_dec Q 0) as [|N]; [tauto|]; exfalso.
    assert (0 <= u * Q) by (now apply Rmult_le_pos); assert (0 <= u * w) by (now apply Rmult_le_pos).
    assert (0 <= w * (u ^ 2 + u * w + Q)) by (apply Rmult_le_pos; [exact W | pose proof (pow2_ge_0 u); lra]); lra.
Qed.

Lemma scaled_negative (a x y : R) : 0 < a -> y = a * x -> (y < 0 <-> x < 0).
Proof. intros A ->; split; intros L; [destruct (Rlt_le_dec x 0); [assumption | nra] | nra]. Qed.

Lemma right_3 (c0 c1 c2 c3 : R) :
  0 < c3 -> (one_right [c0; c1; c2; c3] <-> c0 < 0 \/ c1 < 0 \/ c2 < 0 \/ c2 * c1 - c3 * c0 < 0).
Proof.
  intros P; destruct (real_root c3 c2 c1 c0 ltac:(lra)) as [r E].
  set (w := (c2 + c3 * r) / c3); set (Q := (c1 + c2 * r + c3 * r ^ 2) / c3).
  assert (W : c2 + c3 * r = c3 * w) by (unfold w; field; lra).
  assert (N : c1 + c2 * r + c3 * r ^ 2 = c3 * Q) by (unfold Q; field; lra).
  assert (F : one_right [c0; c1; c2; c3] <-> - r < 0 \/ w < 0 \/ Q < 0).
  { pose proof (quadratic_right c3 (c2 + c3 * r) (c1 + c2 * r + c3 * r ^ 2) P) as R2.
    rewrite (scaled_negative c3 w _ P W), (scaled_negative c3 Q _ P N) in R2; rewrite <- R2.
    unfold one_right; setoid_rewrite as_cubic; setoid_rewrite (fun z => complex_roots c3 c2 c1 c0 r z E); split.
    - intros (z & [->|Z] & L); [left; simpl in L; lra | right; eauto].
    - intros [L|(z & Z & L)]; [exists (RtoC r); split; [now left | simpl; lra] | exists z; tauto]. }
  rewrite F, (signs_3 (- r) w Q).
  assert (E0 : c0 = c3 * (- r * Q)) by (unfold cubic in E; replace (c3 * (- r * Q)) with (- r * (c3 * Q)) by ring; rewrite <- N; lra).
  assert (E2 : c2 = c3 * (- r + w)) by lra.
  assert (E1 : c1 = c3 * (Q + - r * w)).
  { replace (c3 * (Q + - r * w)) with (c3 * Q - r * (c3 * w)) by ring; rewrite <- N, <- W; ring. }
  assert (E3 : c2 * c1 - c3 * c0 = c3 * c3 * (w * ((- r) ^ 2 + - r * w + Q))) by (rewrite E0, E1, E2; ring).
  rewrite (scaled_negative c3 _ _ P E0), (scaled_negative c3 _ _ P E1), (scaled_negative c3 _ _ P E2).
  rewrite (scaled_negative (c3 * c3) _ _ (Rmult_lt_0_compat _ _ P P) E3); tauto.
Qed.

(** ** Degree 4: two quadratics s^2 + p s + q and s^2 + r s + t *)

Lemma even_quartic (P S : R) : exists x y v, P = y + v - x ^ 2 /\ x * (v - y) = 0 /\ S = y * v.
Proof.
  destruct (Rle_lt_dec (4 * S) (P ^ 2)) as [D|D].
  - set (w := sqrt (P ^ 2 - 4 * S)); assert (W : w ^ 2 = P ^ 2 - 4 * S) by (apply root_squared; lra).
    exists 0, ((P - w) / 2), ((P + w) / 2); split; [field | split; [ring|]].
    replace ((P - w) / 2 * ((P + w) / 2)) with ((P ^ 2 - w ^ 2) / 4) by field; rewrite W; field.
  - pose proof (pow2_ge_0 P); set (y := sqrt S); assert (Y : y ^ 2 = S) by (apply root_squared; lra).
    assert (Y0 : 0 <= y) by apply sqrt_pos; assert (B : P <= 2 * y) by nra.
    exists (sqrt (2 * y - P)), y, y; rewrite root_squared by lra; split; [ring | split; [ring | rewrite <- Y; ring]].
Qed.

(** x^4 + P x^2 + T x + S. *)
Lemma depressed_quartic (P T S : R) : exists x y v, P = y + v - x ^ 2 /\ T = x * (v - y) /\ S = y * v.
Proof.
  destruct (Req_dec T 0) as [->|N].
  { destruct (even_quartic P S) as (x & y & v & E1 & E2 & E3); exists x, y, v; repeat split; lra. }
  destruct (root_above (fun z => z ^ 3 + 2 * P * z ^ 2 + (P ^ 2 - 4 * S) * z - T ^ 2) [- T ^ 2; P ^ 2 - 4 * S; 2 * P; 1] 0)
    as (z & L & Z); [intros s; simpl; ring | right; split; [|simpl; lra] |].
  { assert (0 < T ^ 2) by (apply pow2_gt_0; exact N); lra. }
  set (x := sqrt z); assert (X : x ^ 2 = z) by (apply root_squared; lra).
  assert (X0 : x <> 0) by (intros H; rewrite H in X; lra).
  exists x, ((P + z - T / x) / 2), ((P + z + T / x) / 2); split; [rewrite X; field | split; [field|]]; [exact X0 | exact X0 |].
  replace ((P + z - T / x) / 2 * ((P + z + T / x) / 2)) with (((P + z) ^ 2 * x ^ 2 - T ^ 2) / (4 * x ^ 2)) by (field; exact X0).
  rewrite X; apply (Rmult_eq_reg_r (4 * z)); [|lra].
  replace (((P + z) ^ 2 * z - T ^ 2) / (4 * z) * (4 * z)) with ((P + z) ^ 2 * z - T ^ 2) by (field; lra); lra.
Qed.

Lemma quartic_factors (b3 b2 b1 b0 : R) :
  exists p q r t, b3 = p + r /\ b2 = q + t + p * r /\ b1 = p * t + q * r /\ b0 = q * t.
Proof.
  set (m := b3 / 4).
  destruct (depressed_quartic (b2 - 6 * m ^ 2) (b1 - 2 * b2 * m + 8 * m ^ 3) (b0 - b1 * m + b2 * m ^ 2 - 3 * m ^ 4))
    as (x & y & v & E1 & E2 & E3).
  exists (x + 2 * m), (m ^ 2 + x * m + y), (- x + 2 * m), (m ^ 2 - x * m + v).
  assert (B : b3 = 4 * m) by (unfold m; field).
  assert (B2 : b2 = y + v - x ^ 2 + 6 * m ^ 2) by lra.
  assert (B1 : b1 = x * (v - y) + 2 * b2 * m - 8 * m ^ 3) by lra.
  assert (B0 : b0 = y * v + b1 * m - b2 * m ^ 2 + 3 * m ^ 4) by lra.
  split; [rewrite B; ring|]; split; [rewrite B2; ring|]; split; [rewrite B1, B2; ring | rewrite B0, B1, B2; ring].
Qed.

Lemma factored_quartic (c4 p q r t : R) (z : C) :
  at_complex [c4 * (q * t); c4 * (p * t + q * r); c4 * (q + t + p * r); c4 * (p + r); c4] z =
    (RtoC c4 * (quadratic 1 p q z * quadratic 1 r t z))%C.
Proof. destruct z; unfold quadratic; simpl; project; simpl; ring. Qed.

Lemma quartic_roots (c4 p q r t : R) (z : C) :
  0 < c4 ->
  (at_complex [c4 * (q * t); c4 * (p * t + q * r); c4 * (q + t + p * r); c4 * (p + r); c4] z = 0%C <->
   quadratic 1 p q z = 0%C \/ quadratic 1 r t z = 0%C).
Proof.
  intros P; rewrite factored_quartic; split.
  - intros E; apply integral in E; destruct E as [E|E]; [|now apply integral].
    apply (f_equal fst) in E; simpl in E; lra.
  - intros [->| ->]; ring.
Qed.

Lemma left_signs_4 (p q r t : R) :
  (0 < p /\ 0 < q) /\ (0 < r /\ 0 < t) <->
  0 < q * t /\ 0 < p * t + q * r /\ 0 < p + r /\ 0 < p * r * ((q - t) ^ 2 + (p + r) * (p * t + q * r)).
Proof.
  split.
  - intros [[P Q] [R T]]; assert (0 < p * t) by (now apply Rmult_lt_0_compat); assert (0 < q * r) by (now apply Rmult_lt_0_compat).
    assert (0 < (p + r) * (p * t + q * r)) by (apply Rmult_lt_0_compat; lra); pose proof (pow2_ge_0 (q - t)).
    split; [now apply Rmult_lt_0_compat|]; split; [lra|]; split; [lra|].
    apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat | lra].
  - intros (C0 & C1 & C3 & D).
    assert (X : 0 < (q - t) ^ 2 + (p + r) * (p * t + q * r)).
    { assert (0 < (p + r) * (p * t + q * r)) by (now apply Rmult_lt_0_compat); pose proof (pow2_ge_0 (q - t)); lra. }
    assert (M : 0 < p * r) by (destruct (Rlt_le_dec 0 (p * r)); [assumption | nra]).
    assert (P : 0 < p) by (destruct (Rlt_le_dec 0 p); [assumption | nra]); assert (R : 0 < r) by nra.
    assert (Q : 0 < q).
    { destruct (Rlt_le_dec 0 q) as [|L]; [assumption|]; exfalso; assert (t < 0) by nra; assert (q * r <= 0) by nra; nra. }
    assert (0 < t) by nra; tauto.
Qed.

Lemma right_signs_4 (p q r t : R) :
  (p < 0 \/ q < 0) \/ (r < 0 \/ t < 0) <->
  q * t < 0 \/ p * t + q * r < 0 \/ q + t + p * r < 0 \/ p + r < 0 \/
  p * r * ((q - t) ^ 2 + (p + r) * (p * t + q * r)) < 0 \/
  (p * t + q * r = 0 /\ p + r = 0 /\ (q + t + p * r) ^ 2 - 4 * (q * t) < 0).
Proof.
  assert (G : forall p q r t, 0 <= q * t -> 0 <= p * t + q * r -> 0 <= q + t + p * r -> 0 <= p + r ->
    0 <= p * r * ((q - t) ^ 2 + (p + r) * (p * t + q * r)) ->
    ~ (p * t + q * r = 0 /\ p + r = 0 /\ (q + t + p * r) ^ 2 - 4 * (q * t) < 0) -> 0 <= q /\ (0 <= t -> 0 <= p)).
  { clear; intros p q r t C0 C1 C2 C3 D E.
    assert (Q : 0 <= q).
    { destruct (Rle_lt_dec 0 q) as [|L]; [assumption|]; exfalso.
      assert (T : t <= 0) by nra; assert (M : 0 < p * r) by lra.
      assert (P : 0 < p) by (destruct (Rlt_le_dec 0 p); [assumption | nra]); assert (R : 0 < r) by nra.
      assert (q * r < 0) by nra; assert (p * t <= 0) by nra; lra. }
    split; [exact Q|]; intros T; destruct (Rle_lt_dec 0 p) as [|L]; [assumption|]; exfalso.
    assert (R : 0 < r) by lra; assert (M : p * r < 0) by nra.
    assert (K : 0 <= (p + r) * (p * t + q * r)) by (now apply Rmult_le_pos); pose proof (pow2_ge_0 (q - t)) as S.
    assert (X : (q - t) ^ 2 + (p + r) * (p * t + q * r) = 0).
    { destruct (Req_dec ((q - t) ^ 2 + (p + r) * (p * t + q * r)) 0) as [|N]; [assumption|]; exfalso.
      assert (0 < - (p * r) * ((q - t) ^ 2 + (p + r) * (p * t + q * r))) by (apply Rmult_lt_0_compat; lra); lra. }
    assert (S0 : (q - t) ^ 2 = 0) by lra; assert (K0 : (p + r) * (p * t + q * r) = 0) by lra.
    assert (QT : q = t) by (destruct (Req_dec (q - t) 0) as [|N]; [lra | exfalso; pose proof (pow2_gt_0 _ N); lra]).
    subst t; apply Rmult_integral in K0; destruct K0 as [K0|K0].
    - apply E; split; [replace (p * q + q * r) with (q * (p + r)) by ring; rewrite K0; ring | split; [exact K0|]].
      assert (r = - p) by lra; subst r.
      assert (P2 : 0 < p ^ 2) by (apply pow2_gt_0; lra).
      replace ((q + q + p * - p) ^ 2 - 4 * (q * q)) with (- (p ^ 2 * (4 * q - p ^ 2))) by ring.
      assert (0 < p ^ 2 * (4 * q - p ^ 2)) by (apply Rmult_lt_0_compat; lra); lra.
    - destruct (Req_dec q 0) as [->|N]; [lra|].
      assert (p + r = 0) by (apply (Rmult_eq_reg_l q); lra).
      apply E; split; [exact K0 | split; [assumption|]]; assert (r = - p) by lra; subst r.
      assert (P2 : 0 < p ^ 2) by (apply pow2_gt_0; lra).
      replace ((q + q + p * - p) ^ 2 - 4 * (q * q)) with (- (p ^ 2 * (4 * q - p ^ 2))) by ring.
      assert (0 < p ^ 2 * (4 * q - p ^ 2)) by (apply Rmult_lt_0_compat; lra); lra. }
  split.
  - intros H; destruct (Rlt_le_dec (q * t) 0) as [|C0]; [tauto|].
    destruct (Rlt_le_dec (p * t + q * r) 0) as [|C1]; [tauto|].
    destruct (Rlt_le_dec (q + t + p * r) 0) as [|C2]; [tauto|].
    destruct (Rlt_le_dec (p + r) 0) as [|C3]; [tauto|].
    destruct (Rlt_le_dec (p * r * ((q - t) ^ 2 + (p + r) * (p * t + q * r))) 0) as [|D]; [tauto|]; do 5 right.
    destruct (Req_dec (p * t + q * r) 0) as [E1|N1].
    + destruct (Req_dec (p + r) 0) as [E3|N3].
      * split; [exact E1 | split; [exact E3|]].
        destruct (Rlt_le_dec ((q + t + p * r) ^ 2 - 4 * (q * t)) 0) as [|L]; [assumption|]; exfalso.
        destruct (G p q r t C0 C1 C2 C3 D) as [Q P]; [intros (_ & _ & ?); lra|].
        destruct (G r t p q) as [T R]; lra.
      * exfalso; destruct (G p q r t C0 C1 C2 C3 D) as [Q P]; [intros (_ & ? & _); lra|].
        destruct (G r t p q) as [T R]; lra.
    + exfalso; destruct (G p q r t C0 C1 C2 C3 D) as [Q P]; [intros (? & _); lra|].
      destruct (G r t p q) as [T R]; lra.
  - intros H; destruct (Rlt_le_dec p 0) as [|P]; [tauto|]; destruct (Rlt_le_dec q 0) as [|Q]; [tauto|].
    destruct (Rlt_le_dec r 0) as [|R]; [tauto|]; destruct (Rlt_le_dec t 0) as [|T]; [tauto|]; exfalso.
    assert (0 <= q * t) by (now apply Rmult_le_pos); assert (0 <= p * t) by (now apply Rmult_le_pos).
    assert (0 <= q * r) by (now apply Rmult_le_pos); assert (0 <= p * r) by (now apply Rmult_le_pos).
    assert (0 <= (p + r) * (p * t + q * r)) by (apply Rmult_le_pos; lra); pose proof (pow2_ge_0 (q - t)).
    assert (0 <= p * r * ((q - t) ^ 2 + (p + r) * (p * t + q * r))) by (apply Rmult_le_pos; lra).
    destruct H as [H|[H|[H|[H|[H|(E1 & E3 & H)]]]]]; try lra.
    assert (p = 0) by lra; assert (r = 0) by lra; subst p r.
    replace ((q + t + 0 * 0) ^ 2 - 4 * (q * t)) with ((q - t) ^ 2) in H by ring; lra.
Qed.

Lemma scaled_positive (a x y : R) : 0 < a -> y = a * x -> (0 < y <-> 0 < x).
Proof. intros A ->; split; intros L; [destruct (Rlt_le_dec 0 x); [assumption | nra] | nra]. Qed.

Lemma scaled_zero (a x y : R) : 0 < a -> y = a * x -> (y = 0 <-> x = 0).
Proof. intros A ->; split; intros L; [apply (Rmult_eq_reg_l a); lra | rewrite L; ring]. Qed.

Section Quartic.

Variables c0 c1 c2 c3 c4 : R.
Hypotheses (P : 0 < c4).

Lemma scaled_factors :
  exists p q r t, c3 = c4 * (p + r) /\ c2 = c4 * (q + t + p * r) /\ c1 = c4 * (p * t + q * r) /\ c0 = c4 * (q * t).
Proof.
  destruct (quartic_factors (c3 / c4) (c2 / c4) (c1 / c4) (c0 / c4)) as (p & q & r & t & E3 & E2 & E1 & E0).
  exists p, q, r, t; rewrite <- E3, <- E2, <- E1, <- E0; repeat split; field; lra.
Qed.

Lemma left_4 :
  all_left [c0; c1; c2; c3; c4] <-> 0 < c0 /\ 0 < c1 /\ 0 < c3 /\ 0 < c1 * c2 * c3 - c1 ^ 2 * c4 - c0 * c3 ^ 2.
Proof.
  destruct scaled_factors as (p & q & r & t & E3 & E2 & E1 & E0).
  assert (D : c1 * c2 * c3 - c1 ^ 2 * c4 - c0 * c3 ^ 2 =
    c4 ^ 3 * (p * r * ((q - t) ^ 2 + (p + r) * (p * t + q * r)))) by (rewrite E3, E2, E1, E0; ring).
  rewrite (scaled_positive _ _ _ P E0), (scaled_positive _ _ _ P E1), (scaled_positive _ _ _ P E3).
  rewrite (scaled_positive _ _ _ (pow_lt _ 3 P) D), <- (left_signs_4 p q r t).
  rewrite <- (quadratic_stable 1 p q), <- (quadratic_stable 1 r t) by lra; rewrite E3, E2, E1, E0.
  unfold all_left; setoid_rewrite (fun z => quartic_roots c4 p q r t z P); firstorder.
Qed.

Lemma right_4 :
  one_right [c0; c1; c2; c3; c4] <->
  c0 < 0 \/ c1 < 0 \/ c2 < 0 \/ c3 < 0 \/ c1 * c2 * c3 - c1 ^ 2 * c4 - c0 * c3 ^ 2 < 0 \/
  (c1 = 0 /\ c3 = 0 /\ c2 ^ 2 - 4 * c0 * c4 < 0).
Proof.
  destruct scaled_factors as (p & q & r & t & E3 & E2 & E1 & E0).
  assert (D : c1 * c2 * c3 - c1 ^ 2 * c4 - c0 * c3 ^ 2 =
    c4 ^ 3 * (p * r * ((q - t) ^ 2 + (p + r) * (p * t + q * r)))) by (rewrite E3, E2, E1, E0; ring).
  assert (F : c2 ^ 2 - 4 * c0 * c4 = c4 ^ 2 * ((q + t + p * r) ^ 2 - 4 * (q * t))) by (rewrite E2, E0; ring).
  rewrite (scaled_negative _ _ _ P E0), (scaled_negative _ _ _ P E1), (scaled_negative _ _ _ P E2).
  rewrite (scaled_negative _ _ _ P E3), (scaled_zero _ _ _ P E1), (scaled_zero _ _ _ P E3).
  rewrite (scaled_negative _ _ _ (pow_lt _ 3 P) D), (scaled_negative _ _ _ (pow_lt _ 2 P) F), <- (right_signs_4 p q r t).
  rewrite <- (quadratic_right 1 p q), <- (quadratic_right 1 r t) by lra; rewrite E3, E2, E1, E0.
  unfold one_right; setoid_rewrite (fun z => quartic_roots c4 p q r t z P); firstorder.
Qed.

End Quartic.

(** ** Every leading coefficient *)

Lemma left_of_zero : all_left [] <-> False.
Proof. split; [|contradiction]; intros H; specialize (H 0%C eq_refl); simpl in H; lra. Qed.

Lemma right_of_zero : one_right [] <-> True.
Proof. split; [trivial|]; intros _; exists 1%C; split; [reflexivity | simpl; lra]. Qed.

Definition left_form_0 (c : R) : all_left [c] <-> (0 < c /\ True) \/ (0 < - c /\ True) \/ (c = 0 /\ False) :=
  by_leading all_left [] c _ _ _ (left_opposite _) (left_zero _) (left_0 _) (left_0 _) left_of_zero.

Definition left_form_1 (c0 c1 : R) :
  all_left [c0; c1] <-> (0 < c1 /\ 0 < c0) \/ (0 < - c1 /\ 0 < - c0) \/ (c1 = 0 /\ _) :=
  by_leading all_left [c0] c1 _ _ _ (left_opposite _) (left_zero _) (left_1 _ _) (left_1 _ _) (left_form_0 c0).

Definition left_form_2 (c0 c1 c2 : R) : all_left [c0; c1; c2] <-> _ :=
  by_leading all_left [c0; c1] c2 _ _ _ (left_opposite _) (left_zero _) (left_2 _ _ _) (left_2 _ _ _) (left_form_1 c0 c1).

Definition left_form_3 (c0 c1 c2 c3 : R) : all_left [c0; c1; c2; c3] <-> _ :=
  by_leading all_left [c0; c1; c2] c3 _ _ _ (left_opposite _) (left_zero _) (left_3 _ _ _ _) (left_3 _ _ _ _)
    (left_form_2 c0 c1 c2).

Definition left_form_4 (c0 c1 c2 c3 c4 : R) : all_left [c0; c1; c2; c3; c4] <-> _ :=
  by_leading all_left [c0; c1; c2; c3] c4 _ _ _ (left_opposite _) (left_zero _) (left_4 _ _ _ _ _) (left_4 _ _ _ _ _)
    (left_form_3 c0 c1 c2 c3).

Definition right_form_0 (c : R) : one_right [c] <-> _ :=
  by_leading one_right [] c _ _ _ (right_opposite _) (right_zero _) (right_0 _) (right_0 _) right_of_zero.

Definition right_form_1 (c0 c1 : R) : one_right [c0; c1] <-> _ :=
  by_leading one_right [c0] c1 _ _ _ (right_opposite _) (right_zero _) (right_1 _ _) (right_1 _ _) (right_form_0 c0).

Definition right_form_2 (c0 c1 c2 : R) : one_right [c0; c1; c2] <-> _ :=
  by_leading one_right [c0; c1] c2 _ _ _ (right_opposite _) (right_zero _) (right_2 _ _ _) (right_2 _ _ _) (right_form_1 c0 c1).

Definition right_form_3 (c0 c1 c2 c3 : R) : one_right [c0; c1; c2; c3] <-> _ :=
  by_leading one_right [c0; c1; c2] c3 _ _ _ (right_opposite _) (right_zero _) (right_3 _ _ _ _) (right_3 _ _ _ _)
    (right_form_2 c0 c1 c2).

Definition right_form_4 (c0 c1 c2 c3 c4 : R) : one_right [c0; c1; c2; c3; c4] <-> _ :=
  by_leading one_right [c0; c1; c2; c3] c4 _ _ _ (right_opposite _) (right_zero _) (right_4 _ _ _ _ _) (right_4 _ _ _ _ _)
    (right_form_3 c0 c1 c2 c3).

(** ** Real roots *)

Lemma real_by_leading (p : list R) (c : R) (A L : Prop) :
  (c <> 0 -> (all_real (p ++ [c]) <-> A)) -> (all_real p <-> L) ->
  (all_real (p ++ [c]) <-> ((c < 0 \/ 0 < c) /\ A) \/ (c = 0 /\ L)).
Proof.
  intros N Low; destruct (Req_dec c 0) as [->|H].
  - rewrite <- Low; split.
    + intros S; right; split; [reflexivity|]; intros z E; apply S; now rewrite no_root_is_zero.
    + intros [[H _]|[_ S]]; [lra|]; intros z E; apply S; now rewrite no_root_is_zero in E.
  - rewrite (N H); destruct (Rtotal_order c 0) as [|[|]]; intuition lra.
Qed.

Lemma real_of_zero : all_real [] <-> False.
Proof. split; [|contradiction]; intros H; specialize (H Ci eq_refl); simpl in H; lra. Qed.

Lemma real_0 (c : R) : c <> 0 -> (all_real [c] <-> True).
Proof.
  intros N; split; [trivial|]; intros _ z E; exfalso; apply N.
  apply (f_equal fst) in E; destruct z; simpl in E; lra.
Qed.

Lemma real_1 (c0 c1 : R) : c1 <> 0 -> (all_real [c0; c1] <-> True).
Proof.
  intros N; split; [trivial|]; intros _ [x y] E; apply (f_equal snd) in E; simpl in E |- *.
  apply (Rmult_eq_reg_r c1); lra.
Qed.

Lemma real_2 (c0 c1 c2 : R) : c2 <> 0 -> (all_real [c0; c1; c2] <-> 0 <= c1 ^ 2 - 4 * c2 * c0).
Proof.
  intros N; unfold all_real; setoid_rewrite as_quadratic; split.
  - intros S; destruct (Rle_lt_dec 0 (c1 ^ 2 - 4 * c2 * c0)) as [|D]; [assumption|]; exfalso.
    set (w := sqrt (4 * c2 * c0 - c1 ^ 2)); assert (W : w ^ 2 = 4 * c2 * c0 - c1 ^ 2) by (apply root_squared; lra).
    assert (E : quadratic c2 c1 c0 (- c1 / (2 * c2), w / (2 * c2)) = 0%C).
    { apply quadratic_parts; split; [|field; exact N].
      replace (c2 * ((- c1 / (2 * c2)) ^ 2 - (w / (2 * c2)) ^ 2) + c1 * (- c1 / (2 * c2)) + c0)
        with ((4 * c2 * c0 - c1 ^ 2 - w ^ 2) / (4 * c2)) by (field; exact N).
      rewrite W; field; exact N. }
    apply S in E; simpl in E; assert (w = 0) by (apply (Rmult_eq_reg_r (/ (2 * c2))); [unfold Rdiv in E; lra | apply Rinv_neq_0_compat; lra]).
    rewrite H in W; lra.
  - intros D [x y] E; apply quadratic_parts in E; simpl; destruct E as [E1 E2].
    apply Rmult_integral in E2; destruct E2 as [|E2]; [assumption|].
    destruct (Req_dec y 0) as [|Y]; [assumption|]; exfalso.
    assert (B : c1 = - 2 * c2 * x) by lra; rewrite B in D, E1.
    assert (0 < (2 * c2 * y) ^ 2) by (apply pow2_gt_0; repeat apply Rmult_integral_contrapositive_currified; lra).
    assert (C0 : c0 = c2 * (x ^ 2 + y ^ 2)) by lra; rewrite C0 in D; lra.
Qed.

Lemma real_3 (c0 c1 c2 c3 : R) :
  c3 <> 0 -> (all_real [c0; c1; c2; c3] <->
    0 <= 18 * c3 * c2 * c1 * c0 - 4 * c2 ^ 3 * c0 + c2 ^ 2 * c1 ^ 2 - 4 * c3 * c1 ^ 3 - 27 * c3 ^ 2 * c0 ^ 2).
Proof. intros N; unfold all_real; setoid_rewrite as_cubic; exact (real_roots_by_discriminant c3 c2 c1 c0 N). Qed.

Definition real_form_0 (c : R) : all_real [c] <-> _ := real_by_leading [] c _ _ (real_0 _) real_of_zero.

Definition real_form_1 (c0 c1 : R) : all_real [c0; c1] <-> _ := real_by_leading [c0] c1 _ _ (real_1 _ _) (real_form_0 c0).

Definition real_form_2 (c0 c1 c2 : R) : all_real [c0; c1; c2] <-> _ :=
  real_by_leading [c0; c1] c2 _ _ (real_2 _ _ _) (real_form_1 c0 c1).

Definition real_form_3 (c0 c1 c2 c3 : R) : all_real [c0; c1; c2; c3] <-> _ :=
  real_by_leading [c0; c1; c2] c3 _ _ (real_3 _ _ _ _) (real_form_2 c0 c1 c2).
