(** Whole claims on eq 8 of Im and Avouac, over the complex numbers: S1, S5, Q1 and the boundary of vibration. *)

From Slipmode Require Export Cubics.

Section Slider.

Variables a b D K M sigma V : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M) (sigma_pos : 0 < sigma) (V_pos : 0 < V).

(** The coefficients of eq 8. *)
Let c3 := M / sigma.
Let c2 := a / V + M * V / (sigma * D).
Let c1 := K / sigma + (a - b) / D.
Let c0 := K * V / (sigma * D).

(** Eq 9. *)
Let K_c := (b - a) * sigma / D * (1 + M * V ^ 2 / (sigma * a * D)).

Let c3_pos : 0 < c3.
Proof. unfold c3; pos. Qed.

Let c2_pos : 0 < c2.
Proof. unfold c2; pos. Qed.

Let c0_pos : 0 < c0.
Proof. unfold c0; pos. Qed.

Let hurwitz : c2 * c1 - c3 * c0 = a / (V * sigma) * (K - K_c).
Proof. unfold c3, c2, c1, c0, K_c; field; repeat split; apply Rgt_not_eq; assumption. Qed.

Let weight : 0 < a / (V * sigma).
Proof. pos. Qed.

Theorem S1 :
  (stable c3 c2 c1 c0 <-> K_c < K) /\
  ((exists z, complex_cubic c3 c2 c1 c0 z = 0%C /\ 0 < fst z) <-> K < K_c) /\
  ((exists z, complex_cubic c3 c2 c1 c0 z = 0%C /\ fst z = 0) <-> K = K_c).
Proof.
  destruct (sides c3 c2 c1 c0 c3_pos c2_pos c0_pos) as [U I].
  rewrite (routh_hurwitz c3 c2 c1 c0 c3_pos), U, I.
  pose proof hurwitz as H; pose proof weight as W; pose proof c2_pos; pose proof c0_pos.
  split; [|split].
  - split; [intros (_ & _ & L) | intros L; split; [assumption | split; [assumption|]]]; nra.
  - split; intros L; nra.
  - split; intros L; [|rewrite L in H; lra].
    assert (P : a / (V * sigma) * (K - K_c) = 0) by lra.
    apply Rmult_integral in P; destruct P; lra.
Qed.

Theorem S5 : b <= a -> stable c3 c2 c1 c0.
Proof.
  intros L; apply S1; unfold K_c.
  assert (P : 0 < sigma / D * (1 + M * V ^ 2 / (sigma * a * D))) by pos.
  replace ((b - a) * sigma / D * (1 + M * V ^ 2 / (sigma * a * D)))
    with ((b - a) * (sigma / D * (1 + M * V ^ 2 / (sigma * a * D)))) by (field; repeat split; apply Rgt_not_eq; assumption).
  nra.
Qed.

(** Every root that is not real lies inside the circle of the natural frequency. *)
Theorem Q1 (z : C) : complex_cubic c3 c2 c1 c0 z = 0%C -> snd z <> 0 -> fst z ^ 2 + snd z ^ 2 < K / M.
Proof.
  intros Z N.
  destruct (root_below (cubic c3 c2 c1 c0) [c0; c1; c2; c3] [c0; - c1; c2; - c3] (- (V / D))) as (r & L & E).
  { intros s; unfold cubic; simpl; ring. }
  { intros s; simpl; ring. }
  { left; split; [|pose proof c3_pos; simpl; lra].
    replace (cubic c3 c2 c1 c0 (- (V / D))) with (b * V / D ^ 2)
      by (unfold cubic, c3, c2, c1, c0; field; repeat split; apply Rgt_not_eq; assumption).
    pos. }
  apply (complex_roots _ _ _ _ _ _ E) in Z; destruct z as [x y]; simpl in N; destruct Z as [Z|Z].
  { apply (f_equal snd) in Z; contradiction. }
  apply quadratic_parts in Z; destruct Z as [Z1 Z2].
  apply Rmult_integral in Z2; destruct Z2 as [Z2|Z2]; [contradiction|].
  set (B := c2 + c3 * r) in *; set (Q := c1 + c2 * r + c3 * r ^ 2) in *.
  assert (HB : B = - 2 * c3 * x) by lra.
  assert (HQ : Q = c3 * (x ^ 2 + y ^ 2)) by (rewrite HB in Z1; lra).
  assert (HD : c0 = - r * Q) by (unfold Q; unfold cubic in E; lra).
  assert (P : c0 = K / M * c3 * (V / D)).
  { unfold c0, c3; field; repeat split; apply Rgt_not_eq; assumption. }
  assert (R : V / D < - r) by lra.
  assert (R0 : 0 < V / D) by pos.
  assert (T : c3 * (- r * (x ^ 2 + y ^ 2)) = c3 * (K / M * (V / D))) by (rewrite HQ in HD; lra).
  apply Rmult_eq_reg_l in T; [|apply Rgt_not_eq; exact c3_pos].
  assert (S : 0 < x ^ 2 + y ^ 2) by (assert (0 < y ^ 2) by (now apply pow2_gt_0); pose proof (pow2_ge_0 x); lra).
  cbn [fst snd]; apply (Rmult_lt_reg_r (V / D)); [exact R0|]; rewrite <- T; nra.
Qed.

(** Eq 8 has a root that is not real exactly where its discriminant is negative. *)
Theorem vibration :
  (exists z, complex_cubic c3 c2 c1 c0 z = 0%C /\ snd z <> 0) <-> discriminant c3 c2 c1 c0 < 0.
Proof. apply oscillating_root, Rgt_not_eq, c3_pos. Qed.

End Slider.
