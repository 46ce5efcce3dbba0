(** The frequency at σ = σ_c, by the velocity and by the mass: claim Q3 of Im and Avouac, and what Q4 says of the mass. *)

From Slipmode Require Export Exchange Frequency.

(** At σ = σ_c the dimensionless cubic of [Dimensionless] has κ = β − 1. Then y alone gives η and the frequency. *)
Definition inverse_eta (k y : R) := y * (1 + y) ^ 2 / ((1 + y) ^ 2 + k).
Definition square (k y : R) := (1 + y) * (k * y / ((1 + y) ^ 2 + k)) - (k * y / ((1 + y) ^ 2 + k)) ^ 2 / 4.

Lemma critical_parts (eta k y S P : R) : 0 < eta -> 0 < k -> parts eta k (k + 1) y S P ->
  / eta = inverse_eta k y /\ P - S ^ 2 / 4 = square k y.
Proof.
  intros E Q (Y & A & B & C).
  assert (N : 0 < (1 + y) ^ 2 + k) by nra.
  assert (C' : k * (2 - S + y) = (1 + y) * (P - S + 1)).
  { rewrite C; transitivity (eta * (2 - S + y) * ((1 + y) * (P - S + 1))); [ring | rewrite B; ring]. }
  assert (U : (S - 2) * ((1 + y) ^ 2 + k) = k * y).
  { assert (A' : (1 + y) * (y * (P - (k + 1))) = (1 + y) * ((k + 1) * (2 - S))) by now rewrite A.
    assert (C2 : y * (k * (2 - S + y)) = y * ((1 + y) * (P - S + 1))) by now rewrite C'. lra. }
  assert (S2 : S = 2 + k * y / ((1 + y) ^ 2 + k)) by (rewrite <- U; field; lra).
  assert (P2 : P = S - 1 + (1 + y) * (S - 2)).
  { apply (Rmult_eq_reg_l y); [|lra]; rewrite S2; rewrite S2 in A.
    transitivity (y * (P - (k + 1)) + y * (k + 1)); [ring|]; rewrite A; field; lra. }
  split.
  - unfold inverse_eta; replace (y * (1 + y) ^ 2 / ((1 + y) ^ 2 + k)) with (2 - S + y) by (rewrite S2; field; lra).
    apply (Rmult_eq_reg_l eta); [rewrite B; field; lra | lra].
  - unfold square; rewrite P2, S2; field; lra.
Qed.

Lemma inverse_eta_rises (k x y : R) : 0 < k -> 0 < x -> x < y -> inverse_eta k x < inverse_eta k y.
Proof.
  intros Q X L; unfold inverse_eta; set (d := y - x); replace y with (x + d) by (unfold d; ring); assert (D : 0 < d) by (unfold d; lra).
  apply Rminus_gt_0_lt.
  replace ((x + d) * (1 + (x + d)) ^ 2 / ((1 + (x + d)) ^ 2 + k) - x * (1 + x) ^ 2 / ((1 + x) ^ 2 + k))
    with (d * ((1 + x) ^ 2 * (1 + (x + d)) ^ 2 + k * ((1 + x + d) ^ 2 + x * (2 + x + x + d))) /
      (((1 + (x + d)) ^ 2 + k) * ((1 + x) ^ 2 + k)))
    by (field; split; apply Rgt_not_eq; red; pos).
  pos.
Qed.

(** η ω² falls with y. *)
Lemma scaled_square_falls (k x y : R) : 0 < k -> 0 < x -> x < y ->
  square k y / inverse_eta k y < square k x / inverse_eta k x.
Proof.
  intros Q X L; set (d := y - x); replace y with (x + d) by (unfold d; ring); assert (D : 0 < d) by (unfold d; lra).
  apply Rminus_gt_0_lt; unfold square, inverse_eta.
  match goal with |- 0 < ?e => replace e with (
    d * k * (3 * d ^ 3 * k * x + 4 * d ^ 3 * k + 4 * d ^ 3 * x ^ 3 + 12 * d ^ 3 * x ^ 2 + 12 * d ^ 3 * x + 4 * d ^ 3 + 8 * d ^ 2
      * k * x ^ 2 + 20 * d ^ 2 * k * x + 12 * d ^ 2 * k + 12 * d ^ 2 * x ^ 4 + 48 * d ^ 2 * x ^ 3 + 72 * d ^ 2 * x ^ 2 + 48 * d
      ^ 2 * x + 12 * d ^ 2 + 3 * d * k ^ 2 * x + 4 * d * k ^ 2 + 10 * d * k * x ^ 3 + 36 * d * k * x ^ 2 + 42 * d * k * x + 16 *
      d * k + 12 * d * x ^ 5 + 60 * d * x ^ 4 + 120 * d * x ^ 3 + 120 * d * x ^ 2 + 60 * d * x + 12 * d + 3 * k ^ 2 * x ^ 2 + 8
      * k ^ 2 * x + 5 * k ^ 2 + 5 * k * x ^ 4 + 24 * k * x ^ 3 + 42 * k * x ^ 2 + 32 * k * x + 9 * k + 4 * x ^ 6 + 24 * x ^ 5 +
      60 * x ^ 4 + 80 * x ^ 3 + 60 * x ^ 2 + 24 * x + 4) /
    (4 * (x + 1) ^ 2 * (d + x + 1) ^ 2 * (k + (x + 1) ^ 2) * (k + (d + x + 1) ^ 2)))
    by (field; repeat split; apply Rgt_not_eq; red; pos) end.
  pos.
Qed.

(** ω² rises with y. *)
Lemma square_rises (k x y : R) : 0 < k -> 0 < x -> x < y -> square k x < square k y.
Proof.
  intros Q X L; set (d := y - x); replace y with (x + d) by (unfold d; ring); assert (D : 0 < d) by (unfold d; lra).
  apply Rminus_gt_0_lt; unfold square.
  match goal with |- 0 < ?e => replace e with (
    d * k * (4 * d ^ 3 * k ^ 2 + 5 * d ^ 3 * k * x ^ 2 + 12 * d ^ 3 * k * x + 8 * d ^ 3 * k + 4 * d ^ 3 * x ^ 3 + 12 * d ^ 3 * x
      ^ 2 + 12 * d ^ 3 * x + 4 * d ^ 3 + 16 * d ^ 2 * k ^ 2 * x + 12 * d ^ 2 * k ^ 2 + 20 * d ^ 2 * k * x ^ 3 + 60 * d ^ 2 * k *
      x ^ 2 + 64 * d ^ 2 * k * x + 24 * d ^ 2 * k + 12 * d ^ 2 * x ^ 4 + 48 * d ^ 2 * x ^ 3 + 72 * d ^ 2 * x ^ 2 + 48 * d ^ 2 *
      x + 12 * d ^ 2 + 3 * d * k ^ 3 + 24 * d * k ^ 2 * x ^ 2 + 40 * d * k ^ 2 * x + 18 * d * k ^ 2 + 25 * d * k * x ^ 4 + 96 *
      d * k * x ^ 3 + 144 * d * k * x ^ 2 + 100 * d * k * x + 27 * d * k + 12 * d * x ^ 5 + 60 * d * x ^ 4 + 120 * d * x ^ 3 +
      120 * d * x ^ 2 + 60 * d * x + 12 * d + 6 * k ^ 3 * x + 4 * k ^ 3 + 16 * k ^ 2 * x ^ 3 + 40 * k ^ 2 * x ^ 2 + 36 * k ^ 2 *
      x + 12 * k ^ 2 + 10 * k * x ^ 5 + 48 * k * x ^ 4 + 96 * k * x ^ 3 + 100 * k * x ^ 2 + 54 * k * x + 12 * k + 4 * x ^ 6 + 24
      * x ^ 5 + 60 * x ^ 4 + 80 * x ^ 3 + 60 * x ^ 2 + 24 * x + 4) /
    (4 * (k + (x + 1) ^ 2) ^ 2 * (k + (d + x + 1) ^ 2) ^ 2))
    by (field; repeat split; apply Rgt_not_eq; red; pos) end.
  pos.
Qed.

(** ω² is below κ, by less than κ (1 + κ)²/(1 + y). *)
Lemma square_near (k y : R) : 0 < k -> 0 < y -> 0 < square k y /\ square k y < k /\ k - square k y < k * (1 + k) ^ 2 / (1 + y).
Proof.
  intros Q Y; unfold square.
  assert (N : 0 < (1 + y) ^ 2 + k) by pos.
  split; [|split].
  - replace ((1 + y) * (k * y / ((1 + y) ^ 2 + k)) - (k * y / ((1 + y) ^ 2 + k)) ^ 2 / 4)
      with (k * y * (4 * (1 + y) ^ 3 + 4 * k + 3 * k * y) / (4 * ((1 + y) ^ 2 + k) ^ 2)) by (field; lra).
    pos.
  - apply Rminus_gt_0_lt.
    match goal with |- 0 < ?e => replace e with
      (k * (4 * k ^ 2 + 5 * k * y ^ 2 + 12 * k * y + 8 * k + 4 * (1 + y) ^ 3) / (4 * ((1 + y) ^ 2 + k) ^ 2)) by (field; lra) end.
    pos.
  - apply Rminus_gt_0_lt.
    match goal with |- 0 < ?e => replace e with (
      k ^ 2 * (4 * k ^ 3 + 8 * k ^ 2 * y ^ 2 + 16 * k ^ 2 * y + 16 * k ^ 2 + 4 * k * y ^ 4 + 16 * k * y ^ 3 + 40 * k * y ^ 2 +
        44 * k * y + 20 * k + 8 * y ^ 4 + 27 * y ^ 3 + 39 * y ^ 2 + 28 * y + 8) / (4 * (1 + y) * ((1 + y) ^ 2 + k) ^ 2)) by
        (field; lra) end.
    pos.
Qed.

Section CriticalStress.

Variables a b D K : R.
Hypotheses (a_pos : 0 < a) (weakening : a < b) (D_pos : 0 < D) (K_pos : 0 < K).

(** The coefficients of eq 8, eqs 12 and 23 and the natural frequency. *)
Let c3 (M V sigma : R) := M / sigma.
Let c2 (M V sigma : R) := a / V + M * V / (sigma * D).
Let c1 (M V sigma : R) := K / sigma + (a - b) / D.
Let c0 (M V sigma : R) := K * V / (sigma * D).
Let sigma_c := K * D / (b - a).
Let crossing (V : R) := sqrt ((b - a) / a) * V / D.
Let omega_n (M : R) := sqrt (K / M).

(** Eq 8 at σ = σ_c. *)
Let eq_8 (M V : R) := complex_cubic (c3 M V sigma_c) (c2 M V sigma_c) (c1 M V sigma_c) (c0 M V sigma_c).

Let sigma_pos : 0 < sigma_c.
Proof using weakening D_pos K_pos. assert (0 < b - a) by lra; unfold sigma_c; pos. Qed.

Let k := (b - a) / a.
Let inertia (M V : R) := M * V ^ 2 / (sigma_c * a * D).

Let k_pos : 0 < k.
Proof using a_pos weakening. assert (0 < b - a) by lra; unfold k; pos. Qed.

(** The frequency by the number y that belongs to V and M. *)
Let by_y (M V : R) : 0 < M -> 0 < V -> exists y, 0 < y /\ / inertia M V = inverse_eta k y /\
  forall w, 0 <= w -> (highest (eq_8 M V) w <-> w = V / D * sqrt (square k y)).
Proof using a_pos weakening D_pos K_pos sigma_pos k_pos.
  intros m v; assert (E : 0 < inertia M V) by (unfold inertia; pos); assert (b_pos : 0 < b) by lra.
  assert (B : b / a = k + 1) by (unfold k; field; lra).
  assert (Q : K * D / (a * sigma_c) = k) by (unfold k, sigma_c; field; lra).
  destruct (parts_exist (inertia M V) k (k + 1) E k_pos ltac:(lra)) as (y & S & P & T).
  destruct (critical_parts _ _ _ _ _ E k_pos T) as [H1 H2].
  assert (Y : 0 < y) by (destruct T; assumption); destruct (square_near k y k_pos Y) as [W _].
  exists y; split; [exact Y|]; split; [exact H1|].
  assert (F : 0 < V / D) by pos; assert (R : 0 < sqrt (square k y)) by now apply sqrt_lt_R0.
  assert (R2 : sqrt (square k y) ^ 2 = P - S ^ 2 / 4) by (rewrite root_squared by lra; now rewrite H2).
  assert (H : highest (eq_8 M V) (V / D * sqrt (square k y))).
  { split.
    - exists (RtoC (V / D) * ((S - 2) / 2, sqrt (square k y))%R)%C; split; [|now destruct (groups_parts D V ((S - 2) / 2, sqrt (square k y))%R)].
      unfold eq_8, c3, c2, c1, c0; apply (groups a b D K M V sigma_c); try assumption; rewrite B, Q; fold (inertia M V).
      apply (roots _ _ _ _ _ _ E T); right; apply quadratic_parts; rewrite R2; split; field.
    - intros z Z; destruct (groups_onto D V D_pos v z) as [p ->].
      unfold eq_8, c3, c2, c1, c0 in Z; apply (groups a b D K M V sigma_c) in Z; try assumption; rewrite B, Q in Z; fold (inertia M V) in Z.
      rewrite (proj2 (groups_parts D V p)); apply Rmult_le_compat_l; [lra|].
      destruct p as [x w]; simpl; apply (roots _ _ _ _ _ _ E T) in Z; destruct Z as [Z|Z].
      { apply (f_equal snd) in Z; simpl in Z; lra. }
      apply quadratic_parts in Z; destruct Z as [Z1 Z2]; apply Rmult_integral in Z2; destruct Z2 as [->|Z2]; [lra|].
      assert (x = (S - 2) / 2) by lra; subst x.
      assert (w ^ 2 = sqrt (square k y) ^ 2) by (rewrite R2; lra).
      destruct (Rle_lt_dec w (sqrt (square k y))) as [|L]; [assumption|]; exfalso; nra. }
  intros w _; split; [|intros ->; exact H].
  intros [(z & Z & <-) U]; destruct H as [(z' & Z' & E') U'].
  apply Rle_antisym; [now apply U' | rewrite <- E'; now apply U].
Qed.

Let squared (M V y : R) : 0 < M -> 0 < V -> 0 < y -> / inertia M V = inverse_eta k y ->
  (V / D * sqrt (square k y)) ^ 2 = K / M * (a / (b - a)) * (square k y / inverse_eta k y).
Proof using a_pos weakening D_pos K_pos k_pos.
  intros m v Y E; destruct (square_near k y k_pos Y) as [W _]; rewrite <- E, Rpow_mult_distr, root_squared by lra.
  unfold inertia, sigma_c; field; repeat split; lra.
Qed.

(** Claim Q3: at σ = σ_c there is a pair at every velocity; its frequency is eq 23 in the limit V_0 → 0, rises with the velocity, and
    tends to ω_n from below. *)
Theorem Q3 (M : R) : 0 < M ->
  (forall V, 0 < V -> exists w, 0 < w /\ highest (eq_8 M V) w) /\
  (forall e, 0 < e -> exists d, 0 < d /\ forall V w, 0 < V -> V < d -> highest (eq_8 M V) w -> Rabs (w / crossing V - 1) < e) /\
  (forall V W v w, 0 < V -> V < W -> highest (eq_8 M V) v -> highest (eq_8 M W) w -> v < w) /\
  (forall V w, 0 < V -> highest (eq_8 M V) w -> w < omega_n M) /\
  (forall e, 0 < e -> exists V0, 0 < V0 /\ forall V w, V0 < V -> highest (eq_8 M V) w -> Rabs (w - omega_n M) < e).
Proof using a_pos weakening D_pos K_pos sigma_pos k_pos by_y squared.
  intros m; assert (b_pos : 0 < b) by lra; pose proof sigma_pos as SP; pose proof k_pos as KP.
  assert (known : forall V w, 0 < V -> highest (eq_8 M V) w -> exists y, 0 < y /\ / inertia M V = inverse_eta k y /\ 0 < w /\
    w = V / D * sqrt (square k y)).
  { intros V w v H; destruct (by_y M V m v) as (y & Y & E & G); exists y; split; [exact Y|]; split; [exact E|].
    assert (U : 0 < V / D * sqrt (square k y)).
    { apply Rmult_lt_0_compat; [pos|]; apply sqrt_lt_R0; now apply square_near. }
    assert (H' : highest (eq_8 M V) (V / D * sqrt (square k y))) by (apply G; lra).
    assert (E' : w = V / D * sqrt (square k y)).
    { destruct H as [(z & Z & <-) A], H' as [(z' & Z' & <-) A']; apply Rle_antisym; [now apply A' | now apply A]. }
    split; [rewrite E'; exact U | exact E']. }
  split; [|split; [|split; [|split]]].
  - intros V v; destruct (by_y M V m v) as (y & Y & E & G); exists (V / D * sqrt (square k y)).
    assert (U : 0 < V / D * sqrt (square k y)).
    { apply Rmult_lt_0_compat; [pos|]; apply sqrt_lt_R0; now apply square_near. }
    split; [exact U | apply G; lra].
  - intros e He; set (g := M * (1 + k) ^ 2 / (sigma_c * a * D)); assert (G : 0 < g) by (unfold g; pos).
    assert (D0 : 0 < e / g) by pos; exists (Rmin 1 (e / g)); split; [apply Rmin_pos; lra|].
    intros V w v L H; assert (L1 : V < 1) by (eapply Rlt_le_trans; [exact L | apply Rmin_l]).
    assert (L2 : V < e / g) by (eapply Rlt_le_trans; [exact L | apply Rmin_r]).
    destruct (known V w v H) as (y & Y & E & W & ->); destruct (square_near k y KP Y) as (S1 & S2 & S3).
    assert (RK : 0 < sqrt k) by now apply sqrt_lt_R0.
    set (r := sqrt (square k y) / sqrt k).
    assert (R0 : 0 < r) by (unfold r; apply Rdiv_lt_0_compat; [now apply sqrt_lt_R0 | exact RK]).
    assert (R2 : r ^ 2 = square k y / k).
    { unfold r; replace ((sqrt (square k y) / sqrt k) ^ 2) with (sqrt (square k y) ^ 2 / sqrt k ^ 2) by (field; lra).
      now rewrite !root_squared by lra. }
    replace (V / D * sqrt (square k y) / crossing V) with r
      by (unfold r, crossing; fold k; field; repeat split; lra).
    assert (B1 : r ^ 2 < 1).
    { rewrite R2; apply (Rmult_lt_reg_r k); [exact KP|]; replace (square k y / k * k) with (square k y) by (field; lra); lra. }
    assert (B2 : 1 - r ^ 2 < (1 + k) ^ 2 / (1 + y)).
    { rewrite R2; apply (Rmult_lt_reg_r k); [exact KP|].
      replace ((1 - square k y / k) * k) with (k - square k y) by (field; lra).
      replace ((1 + k) ^ 2 / (1 + y) * k) with (k * (1 + k) ^ 2 / (1 + y)) by (field; lra); exact S3. }
    assert (B3 : (1 + k) ^ 2 / (1 + y) < e).
    { assert (P : 0 < inertia M V) by (unfold inertia; pos).
      assert (I : / inertia M V < 1 + y).
      { rewrite E; unfold inverse_eta; apply (Rmult_lt_reg_r ((1 + y) ^ 2 + k)); [pos|].
        replace (y * (1 + y) ^ 2 / ((1 + y) ^ 2 + k) * ((1 + y) ^ 2 + k)) with (y * (1 + y) ^ 2) by (field; apply Rgt_not_eq; red; pos).
        assert (0 < k * (1 + y)) by pos; assert (0 < (1 + y) ^ 2) by pos; lra. }
      assert (J : / (1 + y) < inertia M V).
      { rewrite <- (Rinv_inv (inertia M V)); apply Rinv_lt_contravar; [|exact I].
        apply Rmult_lt_0_compat; [now apply Rinv_0_lt_compat | lra]. }
      assert (X : (1 + k) ^ 2 * inertia M V = g * (V * V)) by (unfold inertia, g; field; repeat split; lra).
      assert (C2 : 0 < (1 + k) ^ 2) by pos.
      apply (Rmult_lt_compat_l ((1 + k) ^ 2)) in J; [|exact C2]; rewrite X in J.
      apply (Rmult_lt_compat_l g) in L2; [|exact G]; replace (g * (e / g)) with e in L2 by (field; lra).
      assert (V * V < V) by nra; assert (g * (V * V) < g * V) by now apply Rmult_lt_compat_l. unfold Rdiv; lra. }
    rewrite Rabs_left by nra; nra.
  - intros V W v w PV L Hv Hw; assert (PW : 0 < W) by lra.
    destruct (known V v PV Hv) as (x & X & EX & V0 & EV); destruct (known W w PW Hw) as (y & Y & EY & W0 & EW).
    assert (C : 0 < K / M * (a / (b - a))) by (assert (0 < b - a) by lra; pos).
    assert (N : inverse_eta k y < inverse_eta k x).
    { rewrite <- EX, <- EY; apply Rinv_lt_contravar.
      - apply Rmult_lt_0_compat; unfold inertia; pos.
      - unfold inertia, Rdiv; apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; pos|]; apply Rmult_lt_compat_l; [exact m|]; nra. }
    assert (O : y < x).
    { destruct (Rtotal_order x y) as [O|[O|O]]; [|subst y; lra|assumption].
      pose proof (inverse_eta_rises k x y KP X O); lra. }
    assert (T : v ^ 2 < w ^ 2).
    { rewrite EV, EW, (squared M V x m PV X EX), (squared M W y m PW Y EY).
      apply Rmult_lt_compat_l; [exact C|]; now apply scaled_square_falls. }
    nra.
  - intros V w v H; destruct (known V w v H) as (y & Y & E & W & _); destruct H as [(z & Z & <-) _].
    assert (N : snd z <> 0) by lra.
    assert (B : fst z ^ 2 + snd z ^ 2 < K / M) by (eapply (Q1 a b D K M sigma_c V); eassumption).
    unfold omega_n; rewrite <- (sqrt_pow2 (snd z)) by lra; apply sqrt_lt_1; [apply pow2_ge_0 | left; pos|].
    pose proof (pow2_ge_0 (fst z)); lra.
  - intros e He; destruct (proj1 (Q2 a b D K M a_pos b_pos D_pos K_pos m) sigma_c e SP He) as (V0 & P & H).
    exists V0; split; [exact P|]; intros V w L Hw; assert (v : 0 < V) by lra.
    destruct (known V w v Hw) as (y & Y & E & W & _); destruct Hw as [(z & Z & <-) _].
    destruct (H V L) as [_ B]; destruct (B z Z ltac:(lra)) as [_ B2]; rewrite (Rabs_pos_eq (snd z)) in B2 by lra; exact B2.
Qed.

(** What claim Q4 says of the mass: with inertia, at σ = σ_c, the frequency falls with it. *)
Theorem Q4_mass (M N V v w : R) : 0 < M -> M < N -> 0 < V -> highest (eq_8 M V) v -> highest (eq_8 N V) w -> w < v.
Proof using a_pos weakening D_pos K_pos sigma_pos k_pos by_y.
  intros m L PV Hv Hw; assert (n : 0 < N) by lra; pose proof sigma_pos as SP; pose proof k_pos as KP.
  destruct (by_y M V m PV) as (x & X & EX & GX), (by_y N V n PV) as (y & Y & EY & GY).
  assert (F : 0 < V / D) by pos.
  assert (R : forall t, 0 < t -> 0 <= V / D * sqrt (square k t)).
  { intros t T; apply Rmult_le_pos; [lra | apply sqrt_pos]. }
  assert (U : forall f p q, highest f p -> highest f q -> p = q).
  { intros f p q [(z & Z & <-) A] [(z' & Z' & <-) A']; apply Rle_antisym; [now apply A' | now apply A]. }
  rewrite (U _ _ _ Hv (proj2 (GX _ (R x X)) eq_refl)), (U _ _ _ Hw (proj2 (GY _ (R y Y)) eq_refl)).
  assert (I : inverse_eta k y < inverse_eta k x).
  { rewrite <- EX, <- EY; apply Rinv_lt_contravar.
    - apply Rmult_lt_0_compat; unfold inertia; pos.
    - unfold inertia, Rdiv; apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; pos|]; apply Rmult_lt_compat_r; [pos | exact L]. }
  assert (O : y < x).
  { destruct (Rtotal_order x y) as [O|[O|O]]; [|subst y; lra|assumption].
    pose proof (inverse_eta_rises k x y KP X O); lra. }
  apply Rmult_lt_compat_l; [exact F|]; apply sqrt_lt_1; [left; now apply square_near | left; now apply square_near|].
  now apply square_rises.
Qed.

End CriticalStress.
