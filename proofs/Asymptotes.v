(** Eq 8 without inertia and for small and large slip distances: eqs 14 to 20, claims B2 to B5 of Im and Avouac. *)

From Slipmode Require Export BoundaryCurve.

(** A limit of complex numbers: that of the real and that of the imaginary part. *)
Definition tends (f : R -> C) (F : (R -> Prop) -> Prop) (l : C) : Prop :=
  filterlim (fun x => fst (f x)) F (locally (fst l)) /\ filterlim (fun x => snd (f x)) F (locally (snd l)).

Lemma affine_near_zero (u v : R) : filterlim (fun x => u + x * v) (locally 0) (locally u).
Proof.
  assert (H : continuous (fun x => u + x * v) 0)
    by (apply (ex_derive_continuous (fun x => u + x * v)); auto_derive; exact I).
  unfold continuous in H; rewrite Rmult_0_l, Rplus_0_r in H; exact H.
Qed.

Lemma affine_limit (u v : R) : filterlim (fun x => u + x * v) (at_right 0) (locally u).
Proof. eapply filterlim_filter_le_1; [apply filter_le_within | apply affine_near_zero]. Qed.

(** An affine function of x from above to 0, and a polynomial of degree 2 in 1/x to infinity. *)
Lemma affine_tends (f : R -> C) (u v : C) :
  (forall x, 0 < x -> f x = (u + RtoC x * v)%C) -> tends f (at_right 0) u.
Proof.
  intros H; split.
  - apply filterlim_ext_loc with (f := fun x => fst u + x * fst v); [|apply affine_limit].
    exists (mkposreal 1 Rlt_0_1); intros x _ P; rewrite (H x P); destruct u, v; simpl; ring.
  - apply filterlim_ext_loc with (f := fun x => snd u + x * snd v); [|apply affine_limit].
    exists (mkposreal 1 Rlt_0_1); intros x _ P; rewrite (H x P); destruct u, v; simpl; ring.
Qed.

Lemma inverse_tends (f : R -> C) (u v w : C) :
  (forall x, 0 < x -> f x = (u + RtoC (/ x) * v + RtoC (/ x ^ 2) * w)%C) -> tends f (Rbar_locally p_infty) u.
Proof.
  intros H; split; [apply (limit_at_infinity _ [fst u; fst v; fst w] [1]) | apply (limit_at_infinity _ [snd u; snd v; snd w] [1])];
    try (intros x P; rewrite (H x P)); destruct u, v, w; simpl; try lra; field; lra.
Qed.

Lemma quadratic_real (a b c : R) :
  0 < a -> ((forall z, quadratic a b c z = 0%C -> snd z = 0) <-> 4 * a * c <= b ^ 2).
Proof.
  intros A; split.
  - intros H; destruct (Rle_lt_dec (4 * a * c) (b ^ 2)) as [|L]; [assumption|]; exfalso.
    destruct (quadratic_root a b c A) as (x & y & Z & _ & _ & I).
    assert (y = 0) by exact (H (x, y) Z); subst y.
    apply quadratic_parts in Z; destruct Z as [Z _]; specialize (I L); nra.
  - intros L [x y] Z; apply quadratic_parts in Z; destruct Z as [Z1 Z2]; simpl.
    apply Rmult_integral in Z2; destruct Z2 as [|Z2]; [assumption|].
    assert (4 * a ^ 2 * y ^ 2 <= 0).
    { assert (b = - 2 * a * x) by lra; subst b; nra. }
    assert (0 < a ^ 2) by now apply pow_lt.
    destruct (Req_dec y 0) as [|N]; [assumption|]; assert (0 < y ^ 2) by now apply pow2_gt_0.
    assert (0 < a ^ 2 * y ^ 2) by now apply Rmult_lt_0_compat; lra. exfalso; lra.
Qed.

Section Asymptotes.

Variables a b K M V sigma : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (K_pos : 0 < K) (M_pos : 0 < M) (V_pos : 0 < V) (sigma_pos : 0 < sigma).

(** The coefficients of eq 8, with the mass and the slip distance that change. *)
Let c3 (M D : R) := M / sigma.
Let c2 (M D : R) := a / V + M * V / (sigma * D).
Let c1 (M D : R) := K / sigma + (a - b) / D.
Let c0 (M D : R) := K * V / (sigma * D).
Let eq_8 (M D : R) := complex_cubic (c3 M D) (c2 M D) (c1 M D) (c0 M D).

Section FixedDistance.

Variable D : R.
Hypotheses (D_pos : 0 < D).

(** The coefficients of eq 14, and eqs 12, 15 and 16. *)
Let g2 := a / V.
Let g1 := K / sigma + (a - b) / D.
Let g0 := K * V / (sigma * D).
Let sigma_c := K * D / (b - a).
Let right_15 := K * D / (sqrt (b) - sqrt (a)) ^ 2.
Let right_16 := K * D / (sqrt (b) + sqrt (a)) ^ 2.

Let p := sqrt a.
Let q := sqrt b.

Let known : 0 < p /\ 0 < q /\ a = p ^ 2 /\ b = q ^ 2.
Proof using a_pos b_pos.
  unfold p, q; rewrite !root_squared by lra; repeat split; now apply sqrt_lt_R0.
Qed.

Let different : a <> b -> q - p <> 0.
Proof using a_pos b_pos. intros N E; apply N; destruct known as (_ & _ & EA & EB); rewrite EA, EB; replace q with p by lra; reflexivity. Qed.

(** Claim B2. *)
Theorem B2 :
  (forall z, tends (fun M => eq_8 M D z) (at_right 0) (quadratic g2 g1 g0 z)) /\
  (a <> b -> ((forall z, quadratic g2 g1 g0 z = 0%C -> snd z = 0) <-> 0 <= (sigma - right_15) * (sigma - right_16))) /\
  (a = b -> ((forall z, quadratic g2 g1 g0 z = 0%C -> snd z = 0) <-> sigma <= K * D / (4 * a))) /\
  (a <> b -> right_16 < right_15).
Proof using a_pos b_pos D_pos K_pos V_pos sigma_pos.
  assert (G : 0 < g2) by (unfold g2; pos); destruct known as (PP & PQ & EA & EB).
  split; [|split; [|split]].
  - intros z; apply affine_tends with (v := (RtoC (/ sigma) * z * z * z + RtoC (V / (sigma * D)) * z * z)%C).
    intros m _; unfold eq_8, c3, c2, c1, c0, g2, g1, g0, complex_cubic, quadratic; destruct z as [x y]; project; field;
      repeat split; apply Rgt_not_eq; assumption.
  - intros N; rewrite (quadratic_real g2 g1 g0 G); apply different in N.
    assert (E : g1 ^ 2 - 4 * g2 * g0 =
                ((q - p) * (q + p) / (sigma * D)) ^ 2 * ((sigma - right_15) * (sigma - right_16))).
    { unfold g1, g2, g0, right_15, right_16; fold p q; rewrite EA, EB; field; repeat split; try (apply Rgt_not_eq; assumption); lra. }
    assert (W : 0 < ((q - p) * (q + p) / (sigma * D)) ^ 2).
    { apply pow2_gt_0; apply Rmult_integral_contrapositive_currified.
      - apply Rmult_integral_contrapositive_currified; lra.
      - apply Rinv_neq_0_compat, Rgt_not_eq; red; pos. }
    set (x := (sigma - right_15) * (sigma - right_16)) in *.
    split; intros L; [|assert (0 <= ((q - p) * (q + p) / (sigma * D)) ^ 2 * x) by (apply Rmult_le_pos; lra); lra].
    destruct (Rle_lt_dec 0 x) as [|X]; [assumption|]; exfalso; nra.
  - intros E; rewrite (quadratic_real g2 g1 g0 G).
    assert (F : g1 ^ 2 - 4 * g2 * g0 = 4 * a * K / (sigma ^ 2 * D) * (K * D / (4 * a) - sigma)).
    { unfold g1, g2, g0; rewrite <- E; field; repeat split; apply Rgt_not_eq; assumption. }
    assert (W : 0 < 4 * a * K / (sigma ^ 2 * D)) by pos.
    split; intros L; nra.
  - intros N; apply different in N; unfold right_15, right_16; fold p q.
    apply Rmult_lt_compat_l; [pos|]; apply Rinv_lt_contravar.
    + apply Rmult_lt_0_compat; [now apply pow2_gt_0 | pos].
    + nra.
Qed.

(** Claim B3. *)
Theorem B3 : (a < b -> sqrt (right_15 * right_16) = sigma_c) /\ (b < a -> right_15 * right_16 = sigma_c ^ 2).
Proof using a_pos b_pos D_pos K_pos.
  destruct known as (PP & PQ & EA & EB).
  assert (E : a <> b -> right_15 * right_16 = sigma_c ^ 2).
  { intros N; apply different in N; unfold right_15, right_16, sigma_c; fold p q; rewrite EA, EB; field; repeat split; try lra.
    replace (q ^ 2 - p ^ 2) with ((q - p) * (q + p)) by ring.
    apply Rmult_integral_contrapositive_currified; lra. }
  split; intros L; [|apply E; lra].
  rewrite E by lra; replace (sigma_c ^ 2) with (sigma_c * sigma_c) by ring; apply sqrt_square.
  left; unfold sigma_c; apply Rdiv_lt_0_compat; [pos | lra].
Qed.

End FixedDistance.

(** The coefficients of eqs 17 and 19, and the left sides of eqs 18 and 20. *)
Let h2 := M.
Let h1 := (a - b) * sigma / V.
Let h0 := K.
Let l2 := M.
Let l1 := a * sigma / V.
Let l0 := K.
Let left_18 := 2 * V * sqrt (M * K) / (Rabs (a - b) * sigma).
Let left_20 := 2 * V * sqrt (M * K) / (a * sigma).

Let discriminant_zero (c : R) : 0 < c ->
  ((c * sigma / V) ^ 2 - 4 * M * K = 0 <-> 2 * V * sqrt (M * K) / (c * sigma) = 1) /\
  (4 * M * K <= (c * sigma / V) ^ 2 <-> 2 * V * sqrt (M * K) / (c * sigma) <= 1).
Proof using K_pos M_pos V_pos sigma_pos.
  intros C; set (r := sqrt (M * K)).
  assert (R0 : 0 < r) by (unfold r; pos).
  assert (R2 : M * K = r ^ 2) by (unfold r; rewrite root_squared; [reflexivity | left; pos]).
  replace (4 * M * K) with (4 * r ^ 2) by lra.
  assert (X : 0 < c * sigma / V) by pos; set (x := c * sigma / V) in *.
  replace (2 * V * r / (c * sigma)) with (2 * r / x) by (unfold x; field; repeat split; apply Rgt_not_eq; assumption).
  assert (E : forall t, 2 * r / x <= t <-> 2 * r <= t * x).
  { intros t; split; intros H.
    - apply (Rmult_le_compat_r x) in H; [|lra]; replace (2 * r / x * x) with (2 * r) in H by (field; lra); exact H.
    - apply (Rmult_le_reg_r x); [exact X|]; replace (2 * r / x * x) with (2 * r) by (field; lra); exact H. }
  split; [split; intros H|rewrite E; split; intros H; nra].
  - assert (2 * r = x) by nra; apply (Rmult_eq_reg_r x); [|lra]; replace (2 * r / x * x) with (2 * r) by (field; lra); lra.
  - assert (2 * r = x); [|nra].
    replace (2 * r) with (2 * r / x * x) by (field; lra); rewrite H; ring.
Qed.

(** Claim B4: eq 17 is the limit for small D, and its imaginary part vanishes exactly up to eq 18, to which the upper arc of
    the boundary tends ([end_18]). *)
Theorem B4 :
  (forall z, tends (fun D => RtoC (sigma * D / V) * eq_8 M D z)%C (at_right 0) (quadratic h2 h1 h0 z)) /\
  (a <> b -> (h1 ^ 2 - 4 * h2 * h0 = 0 <-> left_18 = 1) /\
     ((forall z, quadratic h2 h1 h0 z = 0%C -> snd z = 0) <-> left_18 <= 1)).
Proof using a_pos b_pos K_pos M_pos V_pos sigma_pos.
  split.
  - intros z; apply affine_tends with
      (v := (RtoC (M / V) * z * z * z + RtoC (a * sigma / V ^ 2) * z * z + RtoC (K / V) * z)%C).
    intros D P; unfold eq_8, c3, c2, c1, c0, h2, h1, h0, complex_cubic, quadratic; destruct z as [x y]; project; field;
      repeat split; apply Rgt_not_eq; assumption.
  - intros N; assert (C : 0 < Rabs (a - b)) by (apply Rabs_pos_lt; lra).
    destruct (discriminant_zero (Rabs (a - b)) C) as [Z L]; unfold left_18; rewrite (quadratic_real h2 h1 h0 M_pos).
    assert (E : h1 ^ 2 = (Rabs (a - b) * sigma / V) ^ 2).
    { unfold h1; replace ((Rabs (a - b) * sigma / V) ^ 2) with (Rabs (a - b) ^ 2 * (sigma / V) ^ 2) by (field; lra).
      rewrite pow2_abs; field; lra. }
    rewrite E; unfold h2, h0; split; assumption.
Qed.

(** Claim B5: eq 19 is the limit for large D, and its imaginary part vanishes exactly up to eq 20, to which the lower arc of
    the boundary tends ([end_20]). *)
Theorem B5 :
  (forall z, tends (fun D => RtoC sigma * eq_8 M D z)%C (Rbar_locally p_infty) (z * quadratic l2 l1 l0 z)%C) /\
  (l1 ^ 2 - 4 * l2 * l0 = 0 <-> left_20 = 1) /\
  ((forall z, quadratic l2 l1 l0 z = 0%C -> snd z = 0) <-> left_20 <= 1).
Proof using a_pos b_pos K_pos M_pos V_pos sigma_pos.
  split.
  - intros z; apply inverse_tends with
      (v := (RtoC (M * V) * z * z + RtoC ((a - b) * sigma) * z + RtoC (K * V))%C) (w := RtoC 0).
    intros D P; unfold eq_8, c3, c2, c1, c0, l2, l1, l0, complex_cubic, quadratic; destruct z as [x y]; project; field;
      repeat split; apply Rgt_not_eq; assumption.
  - destruct (discriminant_zero a a_pos) as [Z L]; unfold left_20; rewrite (quadratic_real l2 l1 l0 M_pos).
    unfold l2, l1, l0; split; assumption.
Qed.

End Asymptotes.
