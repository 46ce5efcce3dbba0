(** The frequency of the roots of eq 8: claims Q1, Q2 and Q3 of Im and Avouac. *)

From Slipmode Require Export Dimensionless Slider.

(** ** Bounds in the dimensionless groups *)

Section Bounds.

Variables eta kappa beta y S P : R.
Hypotheses (eta_pos : 0 < eta) (kappa_pos : 0 < kappa) (beta_pos : 0 < beta) (known : parts eta kappa beta y S P).

(** The real root −1 − y lies near −1 where η is large. *)
Lemma real_root_bound : y <= (1 + beta) / eta.
Proof using eta_pos kappa_pos beta_pos known.
  destruct known as (Y & R & E & Q).
  assert (Z : eta * y * (1 + y) ^ 2 = (1 + y) * (y + beta) - kappa * y).
  { rewrite Q; transitivity ((1 + y) * ((y + beta) * (eta * (2 - S + y))) - eta * (1 + y) * (P - S + 1) * y +
      eta * (1 + y) * (y * (P - beta) - beta * (2 - S))); [ring|rewrite E, R; ring]. }
  apply (Rmult_le_reg_r eta); [exact eta_pos|]; replace ((1 + beta) / eta * eta) with (1 + beta) by (field; lra).
  assert (H : eta * y * (1 + y) <= y + beta).
  { apply (Rmult_le_reg_r (1 + y)); [lra|]; assert (0 < kappa * y) by now apply Rmult_lt_0_compat.
    nra. }
  assert (eta * y * (1 + y) <= (1 + beta) * (1 + y)) by nra.
  apply (Rmult_le_reg_r (1 + y)); lra.
Qed.

(** A root u + iv with v <> 0. *)
Lemma pair_of (u v : R) :
  dimensionless eta kappa beta (u, v) = 0%C -> v <> 0 -> 2 * u = S - 2 /\ u ^ 2 + v ^ 2 = P - S + 1.
Proof using eta_pos known.
  intros Z N; apply (roots _ _ _ _ _ _ eta_pos known) in Z; destruct Z as [Z|Z].
  { apply (f_equal snd) in Z; simpl in Z; contradiction. }
  apply quadratic_parts in Z; destruct Z as [Z1 Z2]; apply Rmult_integral in Z2; destruct Z2 as [Z2|Z2]; [contradiction|].
  split; [lra|]; nra.
Qed.

Lemma real_part_bound : Rabs (S - 2) <= (1 + beta) / eta.
Proof using eta_pos kappa_pos beta_pos known.
  pose proof real_root_bound as H; destruct known as (Y & R & E & Q).
  assert (D : S - 2 = y - / eta) by (apply (Rmult_eq_reg_r eta); [|lra]; field_simplify; lra).
  assert (0 < / eta) by now apply Rinv_0_lt_compat.
  assert (/ eta <= (1 + beta) / eta) by (unfold Rdiv; nra).
  rewrite D; apply Rabs_le; lra.
Qed.

Lemma modulus_bounds : kappa / eta / (1 + (1 + beta) / eta) <= P - S + 1 /\ P - S + 1 < kappa / eta.
Proof using eta_pos kappa_pos beta_pos known.
  pose proof real_root_bound as H; destruct known as (Y & R & E & Q).
  assert (D : P - S + 1 = kappa / eta / (1 + y)) by (rewrite Q; field; lra).
  assert (X : 0 < kappa / eta) by now apply Rdiv_lt_0_compat.
  rewrite D; split.
  - apply Rmult_le_compat_l; [lra|]; apply Rinv_le_contravar; lra.
  - apply (Rmult_lt_reg_r (1 + y)); [lra|]; replace (kappa / eta / (1 + y) * (1 + y)) with (kappa / eta) by (field; lra); nra.
Qed.

End Bounds.

Section Frequency.

Variables a b D K M : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M).

(** The coefficients of eq 8. *)
Let c3 (V sigma : R) := M / sigma.
Let c2 (V sigma : R) := a / V + M * V / (sigma * D).
Let c1 (V sigma : R) := K / sigma + (a - b) / D.
Let c0 (V sigma : R) := K * V / (sigma * D).
Let eq_8 (V sigma : R) := complex_cubic (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma).

(** The natural frequency. *)
Let omega_n := sqrt (K / M).

Let omega_squared : omega_n ^ 2 = K / M.
Proof using K_pos M_pos. unfold omega_n; apply root_squared; left; pos. Qed.

Let omega_pos : 0 < omega_n.
Proof using K_pos M_pos. unfold omega_n; apply sqrt_lt_R0; pos. Qed.

(** 1/η: what is small for high velocities and for low normal stresses. *)
Let small (V sigma : R) := (a + b) * sigma * D / (M * V ^ 2).
Let rate (V sigma : R) := (a + b) * sigma / (2 * M * V).

(** The bounds hold for every V and σ. *)
Theorem pair_bounds (V sigma : R) (z : C) :
  0 < V -> 0 < sigma -> eq_8 V sigma z = 0%C -> snd z <> 0 ->
  Rabs (fst z) <= rate V sigma /\
  omega_n ^ 2 / (1 + small V sigma) <= fst z ^ 2 + snd z ^ 2 /\ fst z ^ 2 + snd z ^ 2 < omega_n ^ 2.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros v s Z N.
  set (eta := M * V ^ 2 / (sigma * a * D)); set (kappa := K * D / (a * sigma)); set (beta := b / a).
  assert (E : 0 < eta) by (unfold eta; pos); assert (Q : 0 < kappa) by (unfold kappa; pos).
  assert (B : 0 < beta) by (unfold beta; pos).
  destruct (parts_exist eta kappa beta E Q B) as (y & S & P & T).
  destruct (groups_onto D V D_pos v z) as [p ->].
  unfold eq_8, c3, c2, c1, c0 in Z; apply (groups a b D K M V sigma) in Z; try assumption.
  fold eta kappa beta in Z; destruct (groups_parts D V p) as [EF ES]; rewrite ES in N; rewrite EF, ES.
  assert (F : 0 < V / D) by pos.
  assert (N' : snd p <> 0) by (intros H; apply N; rewrite H; ring).
  destruct p as [x w]; cbn [fst snd] in *; destruct (pair_of eta kappa beta y S P E T x w Z N') as [H1 H2].
  pose proof (real_part_bound eta kappa beta y S P E Q B T) as G; pose proof (modulus_bounds eta kappa beta y S P E Q B T) as [L U].
  assert (X : (V / D) ^ 2 * (kappa / eta) = omega_n ^ 2)
    by (rewrite omega_squared; unfold kappa, eta; field; repeat split; apply Rgt_not_eq; assumption).
  assert (Y : (1 + beta) / eta = small V sigma)
    by (unfold small, eta, beta; field; repeat split; apply Rgt_not_eq; assumption).
  assert (F2 : 0 < (V / D) ^ 2) by now apply pow_lt.
  replace ((V / D * x) ^ 2 + (V / D * w) ^ 2) with ((V / D) ^ 2 * (P - S + 1)) by (rewrite <- H2; ring).
  split; [|split].
  - rewrite Rabs_mult, (Rabs_pos_eq (V / D)) by lra.
    replace (rate V sigma) with (V / D * ((1 + beta) / eta / 2))
      by (rewrite Y; unfold rate, small; field; repeat split; apply Rgt_not_eq; assumption).
    apply Rmult_le_compat_l; [lra|]; replace x with ((S - 2) / 2) by lra.
    unfold Rdiv at 1; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra; lra.
  - rewrite <- Y, <- X.
    replace ((V / D) ^ 2 * (kappa / eta) / (1 + (1 + beta) / eta)) with ((V / D) ^ 2 * (kappa / eta / (1 + (1 + beta) / eta)))
      by (unfold Rdiv; ring).
    apply Rmult_le_compat_l; lra.
  - rewrite <- X; now apply Rmult_lt_compat_l.
Qed.

(** Where the bound on the real part is below that on the modulus there is a pair. *)
Theorem pair_exists (V sigma : R) :
  0 < V -> 0 < sigma -> rate V sigma ^ 2 * (1 + small V sigma) < omega_n ^ 2 ->
  exists z, eq_8 V sigma z = 0%C /\ 0 < snd z.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros v s H.
  set (eta := M * V ^ 2 / (sigma * a * D)) in *; set (kappa := K * D / (a * sigma)); set (beta := b / a).
  assert (E : 0 < eta) by (unfold eta; pos); assert (Q : 0 < kappa) by (unfold kappa; pos).
  assert (B : 0 < beta) by (unfold beta; pos).
  destruct (parts_exist eta kappa beta E Q B) as (y & S & P & T).
  pose proof (real_part_bound eta kappa beta y S P E Q B T) as G; pose proof (modulus_bounds eta kappa beta y S P E Q B T) as [L U].
  assert (X : (V / D) ^ 2 * (kappa / eta) = omega_n ^ 2)
    by (rewrite omega_squared; unfold kappa, eta; field; repeat split; apply Rgt_not_eq; assumption).
  assert (Y : (1 + beta) / eta = small V sigma)
    by (unfold small, eta, beta; field; repeat split; apply Rgt_not_eq; assumption).
  assert (F2 : 0 < (V / D) ^ 2) by (apply pow_lt; pos).
  assert (O : 0 < (1 + beta) / eta) by (apply Rdiv_lt_0_compat; lra).
  assert (R2 : rate V sigma ^ 2 = (V / D) ^ 2 * ((1 + beta) / eta / 2) ^ 2).
  { rewrite Y; unfold rate, small; field; repeat split; apply Rgt_not_eq; assumption. }
  set (m := kappa / eta) in *; set (t := (1 + beta) / eta) in *.
  assert (I : (t / 2) ^ 2 * (1 + t) < m).
  { apply (Rmult_lt_reg_l ((V / D) ^ 2)); [exact F2|]; rewrite X, <- Rmult_assoc, <- R2, Y; exact H. }
  assert (J : (t / 2) ^ 2 < m / (1 + t)).
  { apply (Rmult_lt_reg_r (1 + t)); [lra|]; replace (m / (1 + t) * (1 + t)) with m by (field; lra); exact I. }
  assert (W : ((S - 2) / 2) ^ 2 < P - S + 1).
  { assert (((S - 2) / 2) ^ 2 <= (t / 2) ^ 2); [|lra].
    rewrite <- (pow2_abs ((S - 2) / 2)); apply pow_incr; split; [apply Rabs_pos|].
    unfold Rdiv at 1; rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra; lra. }
  set (w := sqrt (P - S + 1 - ((S - 2) / 2) ^ 2)).
  assert (W0 : 0 < w) by (apply sqrt_lt_R0; lra).
  assert (W2 : w ^ 2 = P - S + 1 - ((S - 2) / 2) ^ 2) by (apply root_squared; lra).
  exists (RtoC (V / D) * (((S - 2) / 2)%R, w))%C; split.
  - unfold eq_8, c3, c2, c1, c0; apply (groups a b D K M V sigma); try assumption; fold eta kappa beta.
    apply (roots _ _ _ _ _ _ E T); right; apply quadratic_parts; split; [rewrite W2; field | field].
  - destruct (groups_parts D V ((S - 2) / 2, w)) as [_ ->]; simpl; apply Rmult_lt_0_compat; [pos | exact W0].
Qed.

(** A pair near ±iω_n: how near follows from how small the two bounds are. *)
Let near (e : R) (V sigma : R) :=
  (exists z, eq_8 V sigma z = 0%C /\ 0 < snd z) /\
  (forall z, eq_8 V sigma z = 0%C -> snd z <> 0 -> Rabs (fst z) < e /\ Rabs (Rabs (snd z) - omega_n) < e).

Let nearness (e : R) : 0 < e -> exists d, 0 < d /\
  forall V sigma, 0 < V -> 0 < sigma -> rate V sigma <= d -> small V sigma <= d -> near e V sigma.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros He; pose proof omega_pos as W.
  set (d := Rmin (Rmin 1 (e / 2)) (Rmin (omega_n / 2) (e / (4 * (omega_n + 1))))).
  assert (D0 : 0 < d).
  { unfold d; repeat apply Rmin_pos; try lra; apply Rdiv_lt_0_compat; lra. }
  assert (D1 : d <= 1) by (unfold d; eapply Rle_trans; [apply Rmin_l | apply Rmin_l]).
  assert (D2 : d <= e / 2) by (unfold d; eapply Rle_trans; [apply Rmin_l | apply Rmin_r]).
  assert (D3 : d <= omega_n / 2) by (unfold d; eapply Rle_trans; [apply Rmin_r | apply Rmin_l]).
  assert (D4 : d * (4 * (omega_n + 1)) <= e).
  { assert (H : d <= e / (4 * (omega_n + 1))) by (unfold d; eapply Rle_trans; [apply Rmin_r | apply Rmin_r]).
    apply (Rmult_le_compat_r (4 * (omega_n + 1))) in H; [|lra].
    replace (e / (4 * (omega_n + 1)) * (4 * (omega_n + 1))) with e in H by (field; lra); exact H. }
  exists d; split; [exact D0|]; intros V sigma v s R1 R2.
  assert (P1 : 0 < rate V sigma) by (unfold rate; pos); assert (P2 : 0 < small V sigma) by (unfold small; pos).
  split.
  - apply pair_exists; try assumption.
    assert (rate V sigma ^ 2 <= (omega_n / 2) ^ 2) by (apply pow_incr; lra).
    assert (0 < omega_n ^ 2) by now apply pow_lt.
    assert (rate V sigma ^ 2 * (1 + small V sigma) <= (omega_n / 2) ^ 2 * 2) by (apply Rmult_le_compat; try lra; apply pow2_ge_0).
    lra.
  - intros z Z N; destruct (pair_bounds V sigma z v s Z N) as (B1 & B2 & B3).
    split; [lra|].
    set (x := fst z) in *; set (y := snd z) in *; rewrite <- (pow2_abs y) in B2, B3; pose proof (Rabs_pos y) as Y0.
    set (t := Rabs y) in *; pose proof (pow2_ge_0 x) as X0; pose proof (Rabs_pos x) as X1.
    assert (X2 : x ^ 2 <= d * omega_n).
    { rewrite <- pow2_abs; replace (Rabs x ^ 2) with (Rabs x * Rabs x) by ring.
      apply Rmult_le_compat; lra. }
    assert (L : omega_n ^ 2 * (1 - d) <= omega_n ^ 2 / (1 + small V sigma)).
    { apply (Rmult_le_reg_r (1 + small V sigma)); [lra|].
      replace (omega_n ^ 2 / (1 + small V sigma) * (1 + small V sigma)) with (omega_n ^ 2) by (field; lra).
      assert (0 < omega_n ^ 2) by now apply pow_lt.
      assert ((1 - d) * (1 + small V sigma) <= 1) by nra.
      replace (omega_n ^ 2 * (1 - d) * (1 + small V sigma)) with (omega_n ^ 2 * ((1 - d) * (1 + small V sigma))) by ring; nra. }
    assert (T : t < omega_n) by (destruct (Rlt_le_dec t omega_n); [assumption|]; exfalso; nra).
    rewrite Rabs_left by lra.
    (* ω² − t² <= d ω² + d ω, and ω − t is that over ω + t. *)
    assert (G : (omega_n - t) * omega_n <= d * omega_n * (omega_n + 1)) by nra.
    assert (G' : omega_n - t <= d * (omega_n + 1)) by (apply (Rmult_le_reg_r omega_n); lra).
    nra.
Qed.

(** Claim Q2 (and that Q1's bound is approached): both V → ∞ and σ → 0 lead to s = ±iω_n; the third root is real. *)
Theorem Q2 :
  (forall sigma e, 0 < sigma -> 0 < e -> exists V0, 0 < V0 /\ forall V, V0 < V -> near e V sigma) /\
  (forall V e, 0 < V -> 0 < e -> exists s0, 0 < s0 /\ forall sigma, 0 < sigma < s0 -> near e V sigma).
Proof using a_pos b_pos D_pos K_pos M_pos.
  split.
  - intros sigma e s He; destruct (nearness e He) as (d & D0 & H).
    set (A := (a + b) * sigma / (2 * M)); set (B := (a + b) * sigma * D / M).
    assert (PA : 0 < A) by (unfold A; pos); assert (PB : 0 < B) by (unfold B; pos).
    exists (1 + A / d + B / d); assert (0 < A / d) by pos; assert (0 < B / d) by pos; split; [lra|]; intros V L.
    assert (V0 : 0 < V) by lra; apply H; try assumption.
    + replace (rate V sigma) with (A / V) by (unfold rate, A; field; repeat split; apply Rgt_not_eq; assumption).
      apply (Rmult_le_reg_r V); [exact V0|]; replace (A / V * V) with (A / d * d) by (field; lra).
      rewrite (Rmult_comm d); apply Rmult_le_compat_r; lra.
    + replace (small V sigma) with (B / V ^ 2) by (unfold small, B; field; repeat split; apply Rgt_not_eq; assumption).
      apply (Rmult_le_reg_r (V ^ 2)); [now apply pow_lt|]; replace (B / V ^ 2 * V ^ 2) with (B / d * d) by (field; lra).
      rewrite (Rmult_comm d); apply Rmult_le_compat_r; [lra|]; nra.
  - intros V e v He; destruct (nearness e He) as (d & D0 & H).
    set (A := (a + b) / (2 * M * V)); set (B := (a + b) * D / (M * V ^ 2)).
    assert (PA : 0 < A) by (unfold A; pos); assert (PB : 0 < B) by (unfold B; pos).
    exists (d / (A + B)); split; [apply Rdiv_lt_0_compat; lra|]; intros sigma [s L].
    assert (G : sigma * (A + B) < d).
    { apply (Rmult_lt_compat_r (A + B)) in L; [|lra]; replace (d / (A + B) * (A + B)) with d in L by (field; lra); exact L. }
    apply H; try assumption.
    + replace (rate V sigma) with (sigma * A) by (unfold rate, A; field; repeat split; apply Rgt_not_eq; assumption); nra.
    + replace (small V sigma) with (sigma * B) by (unfold small, B; field; repeat split; apply Rgt_not_eq; assumption); nra.
Qed.

End Frequency.
