(** The frequency at low velocities: claim Q6 of Im and Avouac. *)

From Slipmode Require Export Exchange Frequency.

(** Where 64 ηκ < 9 a complex pair has a modulus below 2 √κ. *)
Lemma modulus_below (eta kappa beta y S P x w : R) :
  0 < eta -> 0 < kappa -> parts eta kappa beta y S P -> 64 * (eta * kappa) < 9 -> w <> 0 ->
  quadratic 1 (2 - S) (P - S + 1) (x, w) = 0%C -> w ^ 2 < 4 * kappa.
Proof.
  intros E Q (Y & _ & B & C) H N Z; apply quadratic_parts in Z; destruct Z as [Z1 Z2].
  apply Rmult_integral in Z2; destruct Z2 as [Z2|Z2]; [contradiction|].
  assert (X : S = 2 + 2 * x) by lra; subst S.
  assert (M : P - (2 + 2 * x) + 1 = x ^ 2 + w ^ 2) by lra; rewrite M in C; clear M Z1 Z2.
  assert (T : eta * (y - 2 * x) = 1) by lra; assert (W : 0 < w ^ 2) by now apply pow2_gt_0.
  assert (X2 : 0 <= x ^ 2) by apply pow2_ge_0.
  assert (L : 1 <= 4 * (eta * y)).
  { destruct (Rle_lt_dec 1 (4 * (eta * y))) as [|G]; [assumption|]; exfalso.
    assert (G1 : 3 < - 8 * (eta * x)) by lra.
    assert (G2 : 9 < 64 * (eta * x) ^ 2) by nra.
    assert (G3 : eta * kappa = (eta * x) ^ 2 * (1 + y) + (eta * w) ^ 2 * (1 + y)) by (rewrite C; ring).
    assert (0 <= (eta * x) ^ 2 * y) by (apply Rmult_le_pos; [apply pow2_ge_0 | lra]).
    assert (0 <= (eta * w) ^ 2 * (1 + y)) by (apply Rmult_le_pos; [apply pow2_ge_0 | lra]). lra. }
  assert (D : kappa = eta * (x ^ 2 + w ^ 2) + eta * y * (x ^ 2 + w ^ 2)) by (rewrite C; ring).
  assert (0 < eta * (x ^ 2 + w ^ 2)) by (apply Rmult_lt_0_compat; lra).
  assert (1 * (x ^ 2 + w ^ 2) <= 4 * (eta * y) * (x ^ 2 + w ^ 2)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Section LowVelocity.

Variables a b D K M : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M).

(** The coefficients of eq 8, and the natural frequency. *)
Let c3 (V sigma : R) := M / sigma.
Let c2 (V sigma : R) := a / V + M * V / (sigma * D).
Let c1 (V sigma : R) := K / sigma + (a - b) / D.
Let c0 (V sigma : R) := K * V / (sigma * D).
Let omega_n := sqrt (K / M).
Let eq_8 (V sigma : R) := complex_cubic (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma).

(** Left of three quarters of eq 20 every frequency is below 2 √η ω_n. *)
Theorem low_frequency (V sigma : R) (z : C) : 0 < V -> 0 < sigma -> 8 * V * sqrt (M * K) < 3 * (a * sigma) ->
  eq_8 V sigma z = 0%C -> snd z <> 0 -> snd z ^ 2 < 4 * (M * V ^ 2 / (sigma * a * D)) * omega_n ^ 2.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros v s L Z N.
  set (eta := M * V ^ 2 / (sigma * a * D)); set (kappa := K * D / (a * sigma)); set (beta := b / a).
  assert (E : 0 < eta) by (unfold eta; pos); assert (Q : 0 < kappa) by (unfold kappa; pos).
  assert (B : 0 < beta) by (unfold beta; pos).
  destruct (parts_exist eta kappa beta E Q B) as (y & S & P & T).
  destruct (groups_onto D V D_pos v z) as [p ->].
  unfold eq_8, c3, c2, c1, c0 in Z; apply (groups a b D K M V sigma) in Z; try assumption; fold eta kappa beta in Z.
  rewrite (proj2 (groups_parts D V p)) in *.
  assert (R : 0 < sqrt (M * K)) by pos; assert (R2 : sqrt (M * K) ^ 2 = M * K) by (apply root_squared; left; pos).
  assert (H : 64 * (eta * kappa) < 9).
  { replace (eta * kappa) with (V ^ 2 * (M * K) / (a * sigma) ^ 2) by (unfold eta, kappa; field; lra); rewrite <- R2.
    assert (A : 0 < a * sigma) by pos.
    apply (Rmult_lt_reg_r ((a * sigma) ^ 2)); [now apply pow_lt|].
    replace (64 * (V ^ 2 * sqrt (M * K) ^ 2 / (a * sigma) ^ 2) * (a * sigma) ^ 2) with ((8 * V * sqrt (M * K)) ^ 2) by (field; lra).
    assert (0 < 8 * V * sqrt (M * K)) by pos.
    replace (9 * (a * sigma) ^ 2) with ((3 * (a * sigma)) ^ 2) by ring; nra. }
  assert (N' : snd p <> 0) by (intros X; apply N; rewrite X; ring).
  apply (roots _ _ _ _ _ _ E T) in Z; destruct Z as [Z|Z]; [exfalso; apply N'; rewrite Z; reflexivity|].
  destruct p as [x w]; cbn [fst snd] in *.
  pose proof (modulus_below eta kappa beta y S P x w E Q T H N' Z) as W.
  replace (4 * eta * omega_n ^ 2) with ((V / D) ^ 2 * (4 * kappa)).
  - rewrite Rpow_mult_distr; apply Rmult_lt_compat_l; [apply pow_lt; pos | exact W].
  - unfold omega_n; rewrite root_squared by (left; pos); unfold eta, kappa; field; lra.
Qed.

(** Claim Q6: above any normal stress, such as that of eq 16, every frequency is below any given share of ω_n at all velocities that
    are low enough. *)
Theorem Q6 (e least : R) : 0 < e -> 0 < least -> exists V0, 0 < V0 /\ forall V sigma z, 0 < V -> V < V0 -> least <= sigma ->
  eq_8 V sigma z = 0%C -> Rabs (snd z) < e * omega_n.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros He S16.
  assert (R : 0 < sqrt (M * K)) by pos; assert (O : 0 < omega_n) by (unfold omega_n; apply sqrt_lt_R0; pos).
  set (g := 4 * M / (least * a * D)); assert (G : 0 < g) by (unfold g; pos).
  set (f := 3 * (a * least) / (8 * sqrt (M * K))); assert (F : 0 < f) by (unfold f; pos).
  assert (H0 : 0 < e ^ 2 / g) by (apply Rdiv_lt_0_compat; [now apply pow_lt | exact G]).
  exists (Rmin f (Rmin 1 (e ^ 2 / g))); split; [repeat apply Rmin_pos; lra|].
  intros V sigma z v L U Z.
  assert (L1 : V < f) by (eapply Rlt_le_trans; [exact L | apply Rmin_l]).
  assert (L' : V < Rmin 1 (e ^ 2 / g)) by (eapply Rlt_le_trans; [exact L | apply Rmin_r]).
  assert (L2 : V < 1) by (eapply Rlt_le_trans; [exact L' | apply Rmin_l]).
  assert (L3 : V < e ^ 2 / g) by (eapply Rlt_le_trans; [exact L' | apply Rmin_r]).
  destruct (Req_dec (snd z) 0) as [N|N]; [rewrite N, Rabs_R0; now apply Rmult_lt_0_compat|].
  assert (s : 0 < sigma) by lra.
  assert (C : 8 * V * sqrt (M * K) < 3 * (a * sigma)).
  { apply (Rmult_lt_compat_r (8 * sqrt (M * K))) in L1; [|lra].
    replace (f * (8 * sqrt (M * K))) with (3 * (a * least)) in L1 by (unfold f; field; lra).
    assert (a * least <= a * sigma) by (apply Rmult_le_compat_l; lra); lra. }
  pose proof (low_frequency V sigma z v s C Z N) as W.
  assert (O2 : 0 < omega_n ^ 2) by now apply pow_lt.
  assert (B : 4 * (M * V ^ 2 / (sigma * a * D)) < e ^ 2).
  { apply Rle_lt_trans with (g * V ^ 2).
    - replace (4 * (M * V ^ 2 / (sigma * a * D))) with (4 * M / (a * D) * V ^ 2 * / sigma) by (field; lra).
      replace (g * V ^ 2) with (4 * M / (a * D) * V ^ 2 * / least) by (unfold g; field; lra).
      apply Rmult_le_compat_l; [left; pos|]; now apply Rinv_le_contravar.
    - apply (Rmult_lt_compat_l g) in L3; [|exact G]; replace (g * (e ^ 2 / g)) with (e ^ 2) in L3 by (field; lra).
      assert (V ^ 2 < V) by nra; assert (g * V ^ 2 < g * V) by now apply Rmult_lt_compat_l. lra. }
  assert (X : Rabs (snd z) ^ 2 < (e * omega_n) ^ 2).
  { rewrite pow2_abs, Rpow_mult_distr; eapply Rlt_trans; [exact W|]; now apply Rmult_lt_compat_r. }
  pose proof (Rabs_pos (snd z)); assert (0 < e * omega_n) by now apply Rmult_lt_0_compat. nra.
Qed.

End LowVelocity.
