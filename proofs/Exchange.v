(** What eqs 8 to 20 of Im and Avouac depend on: claims S2, B6, B7, B8, Q4, Q5, Z3, Z4 and Z6. *)

From Slipmode Require Export Asymptotes.
From Coq Require Import Machin.

(** The highest imaginary part of the roots. *)
Definition highest (f : C -> C) (w : R) : Prop := (exists z, f z = 0%C /\ snd z = w) /\ forall z, f z = 0%C -> snd z <= w.

Lemma quadratic_conjugate (a b c x y : R) : quadratic a b c (x, y) = 0%C -> quadratic a b c (x, - y) = 0%C.
Proof. rewrite !quadratic_parts; intros [H1 H2]; split; [rewrite <- H1; ring | lra]. Qed.

Lemma quadratic_highest (a b c w : R) : 0 < a -> 0 < w -> (highest (quadratic a b c) w <-> (2 * a * w) ^ 2 = 4 * a * c - b ^ 2).
Proof.
  intros A W; split.
  - intros [([x y] & Z & E) _]; simpl in E; subst y; apply quadratic_parts in Z; destruct Z as [Z1 Z2].
    assert (b = - 2 * a * x) by (apply Rmult_integral in Z2; lra); subst b.
    assert (c = a * (x ^ 2 + w ^ 2)) by lra; subst c; ring.
  - intros E; split.
    + exists (- b / (2 * a), w); split; [|reflexivity]; apply quadratic_parts; split; [|field; lra].
      apply (Rmult_eq_reg_l (4 * a)); [|lra].
      replace (4 * a * (a * ((- b / (2 * a)) ^ 2 - w ^ 2) + b * (- b / (2 * a)) + c)) with (4 * a * c - b ^ 2 - (2 * a * w) ^ 2)
        by (field; lra); lra.
    + intros [x y] Z; simpl; apply quadratic_parts in Z; destruct Z as [Z1 Z2].
      apply Rmult_integral in Z2; destruct Z2 as [->|Z2]; [lra|].
      assert (b = - 2 * a * x) by lra; subst b; assert (c = a * (x ^ 2 + y ^ 2)) by lra; subst c.
      assert (P : a ^ 2 * (w ^ 2 - y ^ 2) = 0) by lra.
      apply Rmult_integral in P; destruct P as [P|P]; [assert (0 < a ^ 2) by pos; lra|]; nra.
Qed.

Lemma cubic_conjugate (a b c d x y : R) : complex_cubic a b c d (x, y) = 0%C -> complex_cubic a b c d (x, - y) = 0%C.
Proof.
  unfold complex_cubic; intros H; pose proof (f_equal fst H) as H1; pose proof (f_equal snd H) as H2.
  cbn [fst snd Cplus Cmult RtoC] in H1, H2; project; [eapply eq_trans; [|exact H1]; ring|].
  eapply eq_trans; [|exact (eq_trans (f_equal Ropp H2) Ropp_0)]; ring.
Qed.

(** The highest imaginary part is zero exactly where all roots are real. *)
Lemma cubic_highest (a b c d : R) : a <> 0 -> (highest (complex_cubic a b c d) 0 <-> real_roots a b c d).
Proof.
  intros A; split.
  - intros [_ H] [x y] Z; simpl; pose proof (H _ Z) as H1; pose proof (H _ (cubic_conjugate _ _ _ _ _ _ Z)) as H2; simpl in *; lra.
  - intros H; split; [|intros z Z; rewrite (H z Z); lra].
    destruct (real_root a b c d A) as [r R]; exists (RtoC r); split; [|reflexivity].
    apply (complex_roots _ _ _ _ _ _ R); now left.
Qed.

Section Exchange.

(** The coefficients of eq 8 and of eq 14. *)
Let c3 (a b D K M V sigma : R) := M / sigma.
Let c2 (a b D K M V sigma : R) := a / V + M * V / (sigma * D).
Let c1 (a b D K M V sigma : R) := K / sigma + (a - b) / D.
Let c0 (a b D K M V sigma : R) := K * V / (sigma * D).
Let q2 (a b D K V sigma : R) := a / V.
Let q1 (a b D K V sigma : R) := K / sigma + (a - b) / D.
Let q0 (a b D K V sigma : R) := K * V / (sigma * D).
Let eq_8 (a b D K M V sigma : R) :=
  complex_cubic (c3 a b D K M V sigma) (c2 a b D K M V sigma) (c1 a b D K M V sigma) (c0 a b D K M V sigma).
Let eq_14 (a b D K V sigma : R) := quadratic (q2 a b D K V sigma) (q1 a b D K V sigma) (q0 a b D K V sigma).

(** Eqs 9, 10, 11, 15, 16, 18 and 20, and the numbers of the text. *)
Let K_c (a b D M V sigma : R) := (b - a) * sigma / D * (1 + M * V ^ 2 / (sigma * a * D)).
Let K_c_qs (a b D M V sigma : R) := (b - a) * sigma / D.
Let K_c_dyn (a b D M V sigma : R) := (b - a) / a * M * V ^ 2 / D ^ 2.
Let right_15 (a b D K : R) := K * D / (sqrt (b) - sqrt (a)) ^ 2.
Let right_16 (a b D K : R) := K * D / (sqrt (b) + sqrt (a)) ^ 2.
Let left_18 (a b K M V sigma : R) := 2 * V * sqrt (M * K) / (Rabs (a - b) * sigma).
Let left_20 (a b D K M V sigma : R) := 2 * V * sqrt (M * K) / (a * sigma).
Let omega_n (K M : R) := sqrt (K / M).
Let eta (a b D K M V sigma : R) := M * V ^ 2 / (sigma * a * D).

(** Claim S2: K_c is the sum of a part that depends on σ but not on M and V_0, and to which it tends as M tends to zero, and of one
    that does not depend on σ and is M V_0² times a number without M and V_0. *)
Theorem S2 (a b D M V sigma M' V' sigma' : R) :
  0 < a -> 0 < b -> 0 < D -> 0 < M -> 0 < V -> 0 < sigma -> 0 < M' -> 0 < V' -> 0 < sigma' ->
  K_c a b D M V sigma = K_c_qs a b D M V sigma + K_c_dyn a b D M V sigma /\
  filterlim (fun M => K_c a b D M V sigma) (at_right 0) (locally (K_c_qs a b D M V sigma)) /\
  (a <> b -> sigma <> sigma' -> K_c_qs a b D M V sigma <> K_c_qs a b D M V sigma') /\
  K_c_qs a b D M V sigma = K_c_qs a b D M' V' sigma /\
  K_c_dyn a b D M V sigma = K_c_dyn a b D M V sigma' /\
  K_c_dyn a b D M V sigma / (M * V ^ 2) = K_c_dyn a b D M' V' sigma / (M' * V' ^ 2).
Proof.
  intros Pa Pb PD PM PV Ps PM' PV' Ps'; unfold K_c, K_c_qs, K_c_dyn; split; [field; lra|]; split.
  { apply (limit_at_zero _ [(b - a) * sigma / D; (b - a) / D * (V ^ 2 / (a * D))] [1]);
      [intros x X; simpl; field; lra | simpl; lra | simpl; field; lra]. }
  split; [|split; [reflexivity | split; [reflexivity | field; lra]]].
  intros N N' H; apply N'.
  replace sigma with ((b - a) * sigma / D * (D / (b - a))) by (field; lra); rewrite H; field; lra.
Qed.

(** How eqs 15, 16, 18 and 20 and η hang together: the mean of eqs 15 and 16, the ratio of eqs 18 and 20, and the square of eq 20. *)
Theorem relations (a b D K M V sigma : R) : 0 < a -> 0 < b -> a <> b -> 0 < D -> 0 < K -> 0 < M -> 0 < V -> 0 < sigma ->
  right_15 a b D K * right_16 a b D K = (K * D / (b - a)) ^ 2 /\
  left_18 a b K M V sigma * Rabs (a - b) = left_20 a b D K M V sigma * a /\
  left_20 a b D K M V sigma ^ 2 = 4 * eta a b D K M V sigma * (K * D / (a * sigma)).
Proof.
  intros Pa Pb N PD PK PM PV Ps; unfold right_15, right_16, left_18, left_20, eta.
  assert (Ra : 0 < sqrt a) by (now apply sqrt_lt_R0); assert (Rb : 0 < sqrt b) by (now apply sqrt_lt_R0).
  assert (S : sqrt b - sqrt a <> 0) by (intros H; apply N, sqrt_inj; lra).
  split; [|split].
  - assert (E : b - a = (sqrt b - sqrt a) * (sqrt b + sqrt a)).
    { rewrite <- (root_squared b) at 1 by lra; rewrite <- (root_squared a) at 1 by lra; ring. }
    rewrite E; field; lra.
  - assert (Rabs (a - b) <> 0) by (apply Rabs_no_R0; lra); field; lra.
  - replace ((2 * V * sqrt (M * K) / (a * sigma)) ^ 2) with (4 * V ^ 2 * sqrt (M * K) ^ 2 / (a * sigma) ^ 2) by (field; lra).
    rewrite root_squared by (left; pos); field; lra.
Qed.

(** Claim B6: when a and b are exchanged, eqs 15, 16 and 18 stay, but each solution V of eq 20 is multiplied by b/a. *)
Theorem B6 (a b D K M : R) : 0 < a -> 0 < b -> a <> b ->
  right_15 b a D K = right_15 a b D K /\ right_16 b a D K = right_16 a b D K /\
  (forall V sigma, left_18 b a K M V sigma = left_18 a b K M V sigma) /\
  (forall V sigma, 0 < sigma -> left_20 a b D K M V sigma = 1 -> left_20 b a D K M (b / a * V) sigma = 1 /\ b / a * V <> V).
Proof.
  intros Pa Pb N; assert (S : sqrt b - sqrt a <> 0).
  { intros H; apply N, sqrt_inj; lra. }
  assert (Ra : 0 < sqrt a) by (now apply sqrt_lt_R0); assert (Rb : 0 < sqrt b) by (now apply sqrt_lt_R0).
  unfold right_15, right_16, left_18, left_20; split; [|split; [|split]].
  - replace ((sqrt a - sqrt b) ^ 2) with ((sqrt b - sqrt a) ^ 2) by ring; reflexivity.
  - replace (sqrt a + sqrt b) with (sqrt b + sqrt a) by ring; reflexivity.
  - intros V sigma; now rewrite (Rabs_minus_sym b a).
  - intros V sigma Ps E; split; [rewrite <- E; field; lra|]; intros H.
    assert (V <> 0) by (intros Z; rewrite Z in E; unfold Rdiv in E; rewrite !Rmult_0_r, !Rmult_0_l in E; lra).
    apply N; replace b with (b / a * V * (a / V)) by (field; lra); rewrite H; field; lra.
Qed.

(** Claim B8: the lines of eqs 15, 16 and 18 are the same after the exchange; that of eq 20 has no point in common with the exchanged one. *)
Theorem B8 (a b D K M : R) : 0 < a -> 0 < b -> a <> b ->
  (forall sigma, sigma = right_15 a b D K <-> sigma = right_15 b a D K) /\
  (forall sigma, sigma = right_16 a b D K <-> sigma = right_16 b a D K) /\
  (forall V sigma, left_18 a b K M V sigma = 1 <-> left_18 b a K M V sigma = 1) /\
  (forall V sigma, 0 < sigma -> left_20 a b D K M V sigma = 1 -> left_20 b a D K M V sigma <> 1).
Proof.
  intros Pa Pb N; destruct (B6 a b D K M Pa Pb N) as (E15 & E16 & E18 & _); rewrite E15, E16.
  split; [tauto|]; split; [tauto|]; split; [intros V sigma; now rewrite E18|].
  unfold left_20; intros V sigma Ps E F; apply N.
  assert (G : 2 * V * sqrt (M * K) = a * sigma).
  { replace (2 * V * sqrt (M * K)) with (2 * V * sqrt (M * K) / (a * sigma) * (a * sigma)) by (field; lra); rewrite E; ring. }
  assert (H : 2 * V * sqrt (M * K) = b * sigma).
  { replace (2 * V * sqrt (M * K)) with (2 * V * sqrt (M * K) / (b * sigma) * (b * sigma)) by (field; lra); rewrite F; ring. }
  apply (Rmult_eq_reg_r sigma); lra.
Qed.

(** Claim B7: without inertia the exchange of a and b multiplies every frequency by a/b; with inertia it moves the contour of zero
    frequency too. *)
Theorem B7 :
  (forall a b D K V sigma w, 0 < a -> 0 < b -> 0 < D -> 0 < K -> 0 < V -> 0 < sigma -> 0 < w ->
     highest (eq_14 a b D K V sigma) w -> highest (eq_14 b a D K V sigma) (a / b * w)) /\
  highest (eq_8 2 3 1 414 10 1 48) 0 /\ ~ highest (eq_8 3 2 1 414 10 1 48) 0.
Proof.
  unfold eq_14, eq_8; split.
  - intros a b D K V sigma w Pa Pb PD PK PV Ps Pw H.
    assert (0 < a / V) by pos; assert (0 < b / V) by pos; assert (0 < a / b * w) by pos.
    apply quadratic_highest in H; try assumption; apply quadratic_highest; try assumption; unfold q2, q1, q0 in *.
    replace (2 * (b / V) * (a / b * w)) with (2 * (a / V) * w) by (field; lra); rewrite H; field; lra.
  - rewrite !cubic_highest, !real_roots_by_discriminant by (unfold c3; lra).
    unfold discriminant, c3, c2, c1, c0; split; lra.
Qed.

(** Claim Q4: without inertia the frequency depends on K: ω² has the derivative ω²/K by K at K = K_c,qs, where it is eq 23 squared. *)
Theorem Q4 (a b D V sigma M : R) : 0 < a -> a < b -> 0 < D -> 0 < V -> 0 < sigma ->
  exists square : R -> R,
    (forall K, 0 < K -> 0 < square K -> highest (eq_14 a b D K V sigma) (sqrt (square K))) /\
    square (K_c_qs a b D M V sigma) = (b - a) / a * V ^ 2 / D ^ 2 /\ 0 < square (K_c_qs a b D M V sigma) /\
    is_derive square (K_c_qs a b D M V sigma) (square (K_c_qs a b D M V sigma) / K_c_qs a b D M V sigma).
Proof.
  intros Pa L PD PV Ps; assert (W : 0 < b - a) by lra.
  exists (fun K => K * V ^ 2 / (a * sigma * D) - (V / (2 * a)) ^ 2 * (K / sigma + (a - b) / D) ^ 2); unfold K_c_qs.
  assert (E : (b - a) * sigma / D * V ^ 2 / (a * sigma * D) - (V / (2 * a)) ^ 2 * ((b - a) * sigma / D / sigma + (a - b) / D) ^ 2 =
    (b - a) / a * V ^ 2 / D ^ 2) by (field; lra).
  split; [|split; [exact E | split; [rewrite E; pos|]]].
  - intros K PK H; unfold eq_14; assert (0 < q2 a b D K V sigma) by (unfold q2; pos).
    apply quadratic_highest; [assumption | now apply sqrt_lt_R0|].
    rewrite Rpow_mult_distr, root_squared by lra; unfold q2, q1, q0; field; lra.
  - auto_derive; [exact I|].
    match goal with |- ?u = ?v => change (u = v :> R) end; field; lra.
Qed.

(** Claim Q5: with the paper's values ω_n = 100 /s, and the period 2π/ω_n rounds to 0.062832 s. *)
Theorem Q5 : omega_n 10000000 1000 = 100 /\ 0.0628315 < 2 * PI / omega_n 10000000 1000 < 0.0628325.
Proof.
  assert (E : omega_n 10000000 1000 = 100).
  { unfold omega_n; replace (10000000 / 1000) with (100 * 100) by lra; apply sqrt_square; lra. }
  rewrite E; split; [reflexivity|].
  pose proof (PI_2_3_7_ineq 2) as [H1 H2].
  unfold sum_f_R0, tg_alt, PI_2_3_7_tg, Ratan_seq in *; simpl in H1, H2; lra.
Qed.

(** Claim Z3: eq 20 holds at one velocity, which depends neither on D_c nor on b and falls with K; η does not depend on K and falls with D_c. *)
Theorem Z3 (a b D K M V sigma b' D' K' : R) :
  0 < a -> 0 < b -> 0 < D -> 0 < K -> 0 < M -> 0 < V -> 0 < sigma -> 0 < b' -> 0 < D' -> 0 < K' ->
  (left_20 a b D K M V sigma = 1 <-> V = V / left_20 a b D K M V sigma) /\
  V / left_20 a b D K M V sigma = V / left_20 a b' D' K M V sigma /\
  (K < K' -> V / left_20 a b D K' M V sigma < V / left_20 a b D K M V sigma) /\
  eta a b D K M V sigma = eta a b D K' M V sigma /\ (D < D' -> eta a b D' K M V sigma < eta a b D K M V sigma).
Proof.
  intros Pa Pb PD PK PM PV Ps Pb' PD' PK'; unfold left_20, eta.
  assert (P : 0 < sqrt (M * K)) by pos.
  split; [|split; [reflexivity | split; [|split; [reflexivity|]]]].
  - set (x := 2 * V * sqrt (M * K) / (a * sigma)); assert (X : 0 < x) by (unfold x; pos); split; intros H.
    + rewrite H; field.
    + apply (Rmult_eq_reg_l (V / x)); [|apply Rgt_not_eq; red; pos]; rewrite <- H at 2; field; lra.
  - intros L; assert (P' : 0 < sqrt (M * K')) by pos.
    replace (V / (2 * V * sqrt (M * K') / (a * sigma))) with (a * sigma / 2 * / sqrt (M * K')) by (field; lra).
    replace (V / (2 * V * sqrt (M * K) / (a * sigma))) with (a * sigma / 2 * / sqrt (M * K)) by (field; lra).
    apply Rmult_lt_compat_l; [pos|]; apply Rinv_lt_contravar; [now apply Rmult_lt_0_compat|].
    apply sqrt_lt_1; [left; pos | left; pos|]; now apply Rmult_lt_compat_l.
  - intros L; replace (M * V ^ 2 / (sigma * a * D')) with (M * V ^ 2 / (sigma * a) * / D') by (field; lra).
    replace (M * V ^ 2 / (sigma * a * D)) with (M * V ^ 2 / (sigma * a) * / D) by (field; lra).
    apply Rmult_lt_compat_l; [pos|]; apply Rinv_lt_contravar; [now apply Rmult_lt_0_compat | exact L].
Qed.

(** Claim Z4: at these numbers eq 8 has real roots only, two of them equal; a smaller a, a larger b or a smaller D_c makes a pair complex. *)
Theorem Z4 :
  (forall z, eq_8 2 3 1 414 10 1 48 z = (RtoC (10 / 48) * (z + RtoC 3) * (z + RtoC 3) * (z + RtoC (23 / 5)))%C) /\
  ~ real_roots (c3 1 3 1 414 10 1 48) (c2 1 3 1 414 10 1 48) (c1 1 3 1 414 10 1 48) (c0 1 3 1 414 10 1 48) /\
  ~ real_roots (c3 2 4 1 414 10 1 48) (c2 2 4 1 414 10 1 48) (c1 2 4 1 414 10 1 48) (c0 2 4 1 414 10 1 48) /\
  ~ real_roots (c3 2 3 (1 / 2) 414 10 1 48) (c2 2 3 (1 / 2) 414 10 1 48) (c1 2 3 (1 / 2) 414 10 1 48) (c0 2 3 (1 / 2) 414 10 1 48).
Proof.
  split; [intros [x y]; unfold eq_8, complex_cubic, c3, c2, c1, c0; project; field|].
  rewrite !real_roots_by_discriminant by (unfold c3; lra).
  unfold discriminant, c3, c2, c1, c0; repeat split; lra.
Qed.

(** Claim Z6: the square of eq 20's left side, and η, are M V_0² times numbers without M and V_0; both rise with M and fall with σ and a. *)
Theorem Z6 (a b D K M V sigma a' M' V' sigma' : R) :
  0 < a -> 0 < b -> 0 < D -> 0 < K -> 0 < M -> 0 < V -> 0 < sigma -> 0 < a' -> 0 < M' -> 0 < V' -> 0 < sigma' ->
  left_20 a b D K M V sigma ^ 2 / (M * V ^ 2) = left_20 a b D K M' V' sigma ^ 2 / (M' * V' ^ 2) /\
  (M < M' -> left_20 a b D K M V sigma < left_20 a b D K M' V sigma) /\
  (sigma < sigma' -> left_20 a b D K M V sigma' < left_20 a b D K M V sigma) /\
  (a < a' -> left_20 a' b D K M V sigma < left_20 a b D K M V sigma) /\
  eta a b D K M V sigma / (M * V ^ 2) = eta a b D K M' V' sigma / (M' * V' ^ 2) /\
  (M < M' -> eta a b D K M V sigma < eta a b D K M' V sigma) /\
  (sigma < sigma' -> eta a b D K M V sigma' < eta a b D K M V sigma) /\
  (a < a' -> eta a' b D K M V sigma < eta a b D K M V sigma).
Proof.
  intros Pa Pb PD PK PM PV Ps Pa' PM' PV' Ps'; unfold left_20, eta.
  assert (P : 0 < sqrt (M * K)) by pos.
  assert (I : forall x y, 0 < x -> x < y -> / y < / x).
  { intros x y X L; apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | exact L]. }
  repeat match goal with |- _ /\ _ => split end.
  - replace ((2 * V * sqrt (M * K) / (a * sigma)) ^ 2) with (4 * V ^ 2 * sqrt (M * K) ^ 2 / (a * sigma) ^ 2) by (field; lra).
    replace ((2 * V' * sqrt (M' * K) / (a * sigma)) ^ 2) with (4 * V' ^ 2 * sqrt (M' * K) ^ 2 / (a * sigma) ^ 2) by (field; lra).
    rewrite !root_squared by (left; pos); field; lra.
  - intros L; unfold Rdiv; apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; pos|]; apply Rmult_lt_compat_l; [pos|].
    apply sqrt_lt_1; [left; pos | left; pos|]; now apply Rmult_lt_compat_r.
  - intros L; unfold Rdiv; apply Rmult_lt_compat_l; [pos|]; apply I; [pos|]; now apply Rmult_lt_compat_l.
  - intros L; unfold Rdiv; apply Rmult_lt_compat_l; [pos|]; apply I; [pos|]; now apply Rmult_lt_compat_r.
  - field; lra.
  - intros L; unfold Rdiv; apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; pos|]; apply Rmult_lt_compat_r; [pos | exact L].
  - intros L; unfold Rdiv; apply Rmult_lt_compat_l; [pos|]; apply I; [pos|].
    apply Rmult_lt_compat_r; [pos|]; now apply Rmult_lt_compat_r.
  - intros L; unfold Rdiv; apply Rmult_lt_compat_l; [pos|]; apply I; [pos|].
    apply Rmult_lt_compat_r; [pos|]; now apply Rmult_lt_compat_l.
Qed.

End Exchange.
