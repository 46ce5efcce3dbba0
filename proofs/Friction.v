(** Friction and the linear theory of Im and Avouac: claims F1, F2, F3, F5, F6, L1, L2 and L3, on eqs 1 to 8.

    v is the slip velocity, V the loading velocity and reference velocity V_0 of the paper. *)

From Slipmode Require Export Cubics.

(** An equation between what Coquelicot has as elements of a module. *)
Ltac real := match goal with |- ?u = ?v => change (u = v :> R) end.

Lemma logarithm_below (x : R) : 0 < x -> x < 1 -> Rabs (x * ln x) < 2 * sqrt x.
Proof.
  intros X L; set (r := sqrt x); assert (P : 0 < r) by (apply sqrt_lt_R0; exact X).
  assert (E : x = r * r) by (unfold r; now rewrite sqrt_sqrt by lra).
  assert (N : ln x < 0) by (rewrite <- ln_1; now apply ln_increasing).
  rewrite Rabs_left by nra; rewrite E, ln_mult by exact P.
  assert (Q : 0 < / r) by now apply Rinv_0_lt_compat.
  assert (U : - ln r < / r).
  { rewrite <- ln_Rinv by exact P; apply exp_lt_inv; rewrite exp_ln by exact Q.
    pose proof (exp_ineq1 (/ r) ltac:(lra)); lra. }
  apply (Rmult_lt_compat_l (2 * r * r)) in U; [|nra].
  replace (2 * r * r * / r) with (2 * r) in U by (field; lra); lra.
Qed.

Section Friction.

Variables a b D K M sigma mu_0 : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M) (sigma_pos : 0 < sigma).

(** Eqs 1 to 4, and the steady state. *)
Let eq_1 (v V theta : R) := mu_0 + a * ln (v / V) + b * ln (V * theta / D).
Let eq_2 (v theta : R) := 1 - v * theta / D.
Let eq_3 (v theta : R) := - v * theta / D * ln (v * theta / D).
Let eq_4_left (delta'' : R) := M * delta'' / sigma.
Let eq_4_right (V t delta mu : R) := K * (V * t - delta) / sigma - mu.
Let theta_ss (v : R) := D / v.
Let mu_ss (v V : R) := mu_0 + (a - b) * ln (v / V).

(** Eqs 5 to 7, by the disturbances and their derivatives in time. *)
Let eq_5 (V Delta_delta Delta_delta' Delta_delta'' Delta_theta : R) := M * Delta_delta'' / sigma + K * Delta_delta / sigma + a * Delta_delta' / V + b * V * Delta_theta / D.
Let eq_6 (V Delta_delta' Delta_theta : R) := - V / D * Delta_theta - 1 / V * Delta_delta'.
Let eq_7 (V Delta_theta Delta_theta' Delta_theta'' Delta_theta''' : R) := M / sigma * Delta_theta''' + (a / V + M * V / (sigma * D)) * Delta_theta'' + (K / sigma + (a - b) / D) * Delta_theta' + K * V / (sigma * D) * Delta_theta.

(** The coefficients of eq 8. *)
Let c3 (V : R) := M / sigma.
Let c2 (V : R) := a / V + M * V / (sigma * D).
Let c1 (V : R) := K / sigma + (a - b) / D.
Let c0 (V : R) := K * V / (sigma * D).

(** Claim F1: eq 2 is steady exactly at θ = D_c/V, and so is eq 3; friction there is μ_0 + (a − b) ln(V/V_0). *)
Theorem F1 (v V theta : R) : 0 < v -> 0 < V -> 0 < theta ->
  (eq_2 v theta = 0 <-> theta = theta_ss v) /\ (eq_3 v theta = 0 <-> theta = theta_ss v) /\
  (forall x, 0 < x -> eq_3 v (x * theta_ss v) = - x * ln x) /\ eq_1 v V (theta_ss v) = mu_ss v V.
Proof using D_pos.
  intros Pv PV Pt; unfold eq_1, eq_2, eq_3, theta_ss, mu_ss.
  assert (S : v * theta / D = 1 <-> theta = D / v).
  { split; intros H; [|rewrite H; field; lra].
    replace theta with (v * theta / D * (D / v)) by (field; lra); rewrite H; ring. }
  assert (X : 0 < v * theta / D) by pos; split; [|split; [|split]].
  - rewrite <- S; lra.
  - rewrite <- S; set (x := v * theta / D) in *; replace (- v * theta / D) with (- x) by (unfold x; field; lra); split; intros H.
    + assert (L : ln x = 0) by (apply Rmult_integral in H; lra); rewrite <- (exp_ln x X), L; apply exp_0.
    + rewrite H, ln_1; ring.
  - intros x Px; replace (v * (x * (D / v)) / D) with x by (field; lra); field; lra.
  - replace (V * (D / v) / D) with (/ (v / V)) by (field; lra); rewrite ln_Rinv by pos; ring.
Qed.

(** Claim F2: at steady state both laws have the same value, the same derivatives by velocity and by state, and with them the same
    derivative along every disturbance. *)
Theorem F2 (v : R) : 0 < v ->
  eq_2 v (theta_ss v) = 0 /\ eq_3 v (theta_ss v) = 0 /\
  exists by_velocity by_state,
    is_derive (fun v' => eq_2 v' (theta_ss v)) v by_velocity /\ is_derive (fun v' => eq_3 v' (theta_ss v)) v by_velocity /\
    is_derive (fun theta => eq_2 v theta) (theta_ss v) by_state /\ is_derive (fun theta => eq_3 v theta) (theta_ss v) by_state /\
    forall x y,
      is_derive (fun e => eq_2 (v + e * x) (theta_ss v + e * y)) 0 (by_velocity * x + by_state * y) /\
      is_derive (fun e => eq_3 (v + e * x) (theta_ss v + e * y)) 0 (by_velocity * x + by_state * y).
Proof using D_pos.
  intros P; assert (E : v * (D / v) / D = 1) by (field; lra); assert (E' : v * (D / v) * / D = 1) by (field; lra).
  unfold eq_2, eq_3, theta_ss.
  split; [rewrite E; ring|]; split; [rewrite E, ln_1; ring|].
  exists (- (1 / v)), (- (v / D)); split; [|split; [|split; [|split]]].
  - auto_derive; [exact I|]; real; field; lra.
  - auto_derive; [rewrite E'; lra|]; rewrite E', ln_1; real; field; lra.
  - auto_derive; [exact I|]; real; field; lra.
  - auto_derive; [rewrite E'; lra|]; rewrite E', ln_1; real; field; lra.
  - intros x y; split.
    + auto_derive; [exact I|]; rewrite !Rmult_0_l, !Rplus_0_r; real; field; lra.
    + auto_derive; rewrite !Rmult_0_l, !Rplus_0_r; [rewrite E'; repeat split; try exact I; lra|].
      rewrite E', ln_1; real; field; lra.
Qed.

(** Claim F3: as the velocity tends to zero at a given state, the rate of the state tends to 1 with the aging law and to 0 with the slip law. *)
Theorem F3 (theta : R) : 0 < theta ->
  filterlim (fun v => eq_2 v theta) (at_right 0) (locally 1) /\ filterlim (fun v => eq_3 v theta) (at_right 0) (locally 0).
Proof using D_pos.
  intros T; unfold eq_2, eq_3; split.
  - apply (limit_at_zero _ [1; - theta / D] [1]); [intros v P; simpl; field; lra | simpl; lra | simpl; field; lra].
  - apply filterlim_locally; intros e; set (g := Rmin 1 ((e / 2) ^ 2)).
    assert (E : 0 < e) by apply cond_pos.
    assert (G : 0 < g) by (unfold g; apply Rmin_pos; [lra | apply pow_lt; lra]).
    assert (R : 0 < g * D / theta) by pos.
    exists (mkposreal _ R); intros v B P; unfold ball in *; simpl in *; unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
    rewrite Ropp_0, Rplus_0_r, Rabs_pos_eq in B by lra; rewrite Ropp_0, Rplus_0_r.
    set (x := v * theta / D); assert (X : 0 < x) by (unfold x; pos).
    assert (L : x < g).
    { apply (Rmult_lt_compat_r (theta / D)) in B; [|pos].
      replace (g * D / theta * (theta / D)) with g in B by (field; lra); unfold x; lra. }
    replace (- v * theta / D * ln x) with (- (x * ln x)) by (unfold x; field; lra); rewrite Rabs_Ropp.
    assert (L1 : x < 1) by (eapply Rlt_le_trans; [exact L | apply Rmin_l]).
    assert (L2 : x < (e / 2) ^ 2) by (eapply Rlt_le_trans; [exact L | apply Rmin_r]).
    pose proof (logarithm_below x X L1) as U; assert (sqrt x < e / 2); [|lra].
    rewrite <- (sqrt_pow2 (e / 2)) by lra; apply sqrt_lt_1; lra.
Qed.

(** Claim F5: at V = 0 the state of the aging law grows as the time, and friction at every velocity as b ln of it; at a given state
    friction is lower by a ln z at V/z than at V. *)
Theorem F5 (V theta : R) : 0 < V -> 0 < theta ->
  filterlim (fun v => eq_2 v theta) (at_right 0) (locally 1) /\
  (forall v, 0 < v -> exists slope, is_derive (fun theta => eq_1 v V theta) theta slope /\ theta * slope = b) /\
  (forall t, is_derive (fun t => theta + t) t (eq_2 0 (theta + t))) /\
  (forall state : R -> R, (forall t, is_derive state t (eq_2 0 (state t))) -> state 0 = theta ->
     forall t v, 0 <= t -> 0 < v -> state t = theta + t /\ eq_1 v V (state t) - eq_1 v V theta = b * ln (1 + t / theta)) /\
  (forall t, 0 < t -> 0 < b * ln (1 + t / theta)) /\
  (forall v z, 0 < v -> 0 < z -> eq_1 (v / z) V theta = eq_1 v V theta - a * ln z).
Proof using b_pos D_pos.
  intros PV T; split; [exact (proj1 (F3 theta T))|]; split; [|split; [|split; [|split]]].
  - intros v P; exists (b / theta); split; [|field; lra].
    unfold eq_1; auto_derive; [pos|]; real; field; repeat split; lra.
  - intros t; unfold eq_2; auto_derive; [exact I|]; real; field; lra.
  - intros state S S0 t v Pt Pv.
    assert (E : state t = theta + t).
    { destruct (MVT_gen (fun t => state t - t) 0 t (fun _ => 0)) as (c & _ & H).
      - intros x _; pose proof (is_derive_minus state (fun t => t) x _ _ (S x) (is_derive_id x)) as W.
        refine (eq_ind _ (fun q => is_derive (fun t => state t - t) x q) W 0 _).
        unfold eq_2, minus, plus, opp, one; simpl; field; lra.
      - intros x _; apply continuity_pt_filterlim, (continuous_minus state (fun t => t)); [|apply continuous_id].
        apply (ex_derive_continuous (V := R_NormedModule)); exists (eq_2 0 (state x)); apply S.
      - rewrite S0 in H; lra. }
    split; [exact E|]; rewrite E; unfold eq_1.
    replace (V * (theta + t) / D) with (V * theta / D * (1 + t / theta)) by (field; lra).
    rewrite ln_mult; [ring | pos |]; assert (0 <= t / theta) by (apply Rdiv_le_0_compat; lra); lra.
  - intros t P; apply Rmult_lt_0_compat; [exact b_pos|]; rewrite <- ln_1; apply ln_increasing; [lra|].
    assert (0 < t / theta) by pos; lra.
  - intros v z Pv Pz; unfold eq_1; replace (v / z / V) with (v / V / z) by (field; lra).
    rewrite (ln_quotient (v / V) z) by pos; ring.
Qed.

(** Claim F6: in place of V_0 another reference velocity V_r adds a constant to eq 1, as another μ_0 does; with every V_r and μ_0
    steady sliding at the loading velocity V solves eq 4, and the derivative of eq 4 along every disturbance is eq 5, which contains
    neither of them. *)
Theorem F6 (V V_r t Delta_delta Delta_delta' Delta_delta'' Delta_theta : R) : 0 < V -> 0 < V_r ->
  (forall v theta, 0 < v -> 0 < theta -> eq_1 v V_r theta = eq_1 v V theta + (b - a) * ln (V_r / V)) /\
  let mu := eq_1 V V_r (theta_ss V) in
  let delta := V * t - sigma * mu / K in
  eq_4_left 0 = eq_4_right V t delta mu /\
  is_derive (fun e => eq_4_left (e * Delta_delta'') -
      eq_4_right V t (delta + e * Delta_delta) (eq_1 (V + e * Delta_delta') V_r (theta_ss V + e * Delta_theta))) 0
    (eq_5 V Delta_delta Delta_delta' Delta_delta'' Delta_theta).
Proof using D_pos K_pos sigma_pos.
  intros P Pr; split; [intros v theta Pv Pt; unfold eq_1; logarithms; ring|].
  intros mu delta; assert (E : V_r * (D / V) * / D = V_r / V) by (field; lra).
  split; [unfold eq_4_left, eq_4_right, delta; field; lra|].
  unfold eq_1, eq_4_left, eq_4_right, eq_5, theta_ss.
  auto_derive; rewrite !Rmult_0_l, !Rplus_0_r; [rewrite E; repeat split; try exact I; pos|].
  real; field; repeat split; lra.
Qed.

(** Claim L1: steady sliding solves eqs 1 to 4 with either law, and the derivatives of the equations along every disturbance are eqs 5 and 6. *)
Theorem L1 (V t Delta_delta Delta_delta' Delta_delta'' Delta_theta : R) : 0 < V ->
  let mu := eq_1 V V (theta_ss V) in
  let delta := V * t - sigma * mu / K in
  eq_4_left 0 = eq_4_right V t delta mu /\ eq_2 V (theta_ss V) = 0 /\ eq_3 V (theta_ss V) = 0 /\
  is_derive (fun e => eq_4_left (e * Delta_delta'') -
      eq_4_right V t (delta + e * Delta_delta) (eq_1 (V + e * Delta_delta') V (theta_ss V + e * Delta_theta))) 0
    (eq_5 V Delta_delta Delta_delta' Delta_delta'' Delta_theta) /\
  is_derive (fun e => eq_2 (V + e * Delta_delta') (theta_ss V + e * Delta_theta)) 0 (eq_6 V Delta_delta' Delta_theta) /\
  is_derive (fun e => eq_3 (V + e * Delta_delta') (theta_ss V + e * Delta_theta)) 0 (eq_6 V Delta_delta' Delta_theta).
Proof using D_pos K_pos sigma_pos.
  intros P mu delta; assert (E : V * (D / V) / D = 1) by (field; lra).
  assert (E' : V * (D / V) * / D = 1) by (field; lra).
  split; [unfold eq_4_left, eq_4_right, delta; field; lra|].
  split; [unfold eq_2, theta_ss; rewrite E; ring|]; split; [unfold eq_3, theta_ss; rewrite E, ln_1; ring|].
  unfold eq_1, eq_2, eq_3, eq_4_left, eq_4_right, eq_5, eq_6, theta_ss; split; [|split].
  - auto_derive; rewrite !Rmult_0_l, !Rplus_0_r; [repeat split; try exact I; pos|].
    rewrite E'; real; field; repeat split; lra.
  - auto_derive; [exact I|]; rewrite !Rmult_0_l, !Rplus_0_r; real; field; lra.
  - auto_derive; rewrite !Rmult_0_l, !Rplus_0_r; [rewrite E'; repeat split; try exact I; lra|].
    rewrite E', ln_1; real; field; lra.
Qed.

(** Claim L2: where eq 6 holds at all times, the left side of eq 5 has the derivative −V_0 times the left side of eq 7; so eqs 5 and 6
    give eq 7. *)
Theorem L2 (V : R) (x x' x'' y y' y'' y''' : R -> R) : 0 < V ->
  (forall t, is_derive x t (x' t)) -> (forall t, is_derive x' t (x'' t)) ->
  (forall t, is_derive y t (y' t)) -> (forall t, is_derive y' t (y'' t)) -> (forall t, is_derive y'' t (y''' t)) ->
  (forall t, y' t = eq_6 V (x' t) (y t)) ->
  (forall t, is_derive (fun t => eq_5 V (x t) (x' t) (x'' t) (y t)) t (- V * eq_7 V (y t) (y' t) (y'' t) (y''' t))) /\
  ((forall t, eq_5 V (x t) (x' t) (x'' t) (y t) = 0) -> forall t, eq_7 V (y t) (y' t) (y'' t) (y''' t) = 0).
Proof using D_pos sigma_pos.
  intros P X X' Y Y' Y'' E6.
  assert (E1 : forall t, x' t = - V * (y' t + V / D * y t)) by (intros t; rewrite E6; unfold eq_6; field; lra).
  assert (E2 : forall t, x'' t = - V * (y'' t + V / D * y' t)).
  { intros t; rewrite <- (is_derive_unique (fun t => x' t) t _ (X' t)).
    apply is_derive_unique, (is_derive_ext (fun t => - V * (y' t + V / D * y t))); [intros s; symmetry; apply E1|].
    auto_derive; [split; [exists (y'' t) | split; [exists (y' t) | exact I]]; auto|].
    rewrite (is_derive_unique (fun x : R => y' x) t _ (Y' t)), (is_derive_unique (fun x : R => y x) t _ (Y t)); real; ring. }
  assert (R : forall t, is_derive (fun t => eq_5 V (x t) (x' t) (x'' t) (y t)) t (- V * eq_7 V (y t) (y' t) (y'' t) (y''' t))).
  { intros t; apply (is_derive_ext (fun t => eq_5 V (x t) (- V * (y' t + V / D * y t)) (- V * (y'' t + V / D * y' t)) (y t))).
    { intros s; now rewrite E1, E2. }
    unfold eq_5; auto_derive; [repeat split; try exact I; eexists; eauto|].
    rewrite (is_derive_unique (fun x : R => y' x) t _ (Y' t)), (is_derive_unique (fun x : R => y x) t _ (Y t)),
      (is_derive_unique (fun x : R => y'' x) t _ (Y'' t)), (is_derive_unique (fun x' : R => x x') t _ (X t)), E1.
    unfold eq_7; real; field; repeat split; lra. }
  split; [exact R|]; intros Z t.
  assert (H : - V * eq_7 V (y t) (y' t) (y'' t) (y''' t) = 0).
  { rewrite <- (is_derive_unique _ _ _ (R t)); apply is_derive_unique, (is_derive_ext (fun _ => 0)).
    - intros s; now rewrite Z.
    - apply (is_derive_const (V := R_NormedModule)). }
  apply Rmult_integral in H; lra.
Qed.

(** Claim L3: a motion with the factor exp(s t) has amplitudes that are not both zero and solve eqs 5 and 6 exactly where s is a root of eq 8. *)
Theorem L3 (V : R) (s : C) : 0 < V ->
  let solves (x y : C) :=
    let law (part : C -> R) :=
      eq_5 V (part x) (part (s * x)%C) (part (s * s * x)%C) (part y) = 0 /\ part (s * y)%C = eq_6 V (part (s * x)%C) (part y) in
    law fst /\ law snd in
  (exists x y : C, (x <> 0%C \/ y <> 0%C) /\ solves x y) <-> complex_cubic (c3 V) (c2 V) (c1 V) (c0 V) s = 0%C.
Proof using b_pos D_pos sigma_pos.
  intros P solves.
  set (p := (RtoC (M / sigma) * s * s + RtoC (a / V) * s + RtoC (K / sigma))%C).
  assert (D1 : forall x y, solves x y <->
    (p * x + RtoC (b * V / D) * y = 0)%C /\ ((s + RtoC (V / D)) * y + RtoC (/ V) * s * x = 0)%C).
  { intros [x1 x2] [y1 y2]; destruct s as [u v]; unfold solves, p, eq_5, eq_6; cbn [fst snd Cmult]; split.
    - intros ((A1 & A2) & A3 & A4); apply Rminus_diag_eq in A2; apply Rminus_diag_eq in A4; split; project; eapply eq_trans;
        [|exact A1| |exact A3| |exact A2| |exact A4]; field; lra.
    - intros [A1 A2]; pose proof (f_equal fst A1) as B1; pose proof (f_equal snd A1) as B2.
      pose proof (f_equal fst A2) as B3; pose proof (f_equal snd A2) as B4.
      cbn [fst snd Cplus Cmult RtoC] in *; repeat split; try apply Rminus_diag_uniq; eapply eq_trans;
        [|exact B1| |exact B3| |exact B2| |exact B4]; field; lra. }
  assert (N : complex_cubic (c3 V) (c2 V) (c1 V) (c0 V) s =
    (p * (s + RtoC (V / D)) - RtoC (b * V / D) * (RtoC (/ V) * s))%C).
  { unfold p, complex_cubic, c3, c2, c1, c0; destruct s as [u v]; project; field; repeat split; lra. }
  split.
  - intros (x & y & Z & S); apply D1 in S; destruct S as [S1 S2].
    assert (X : (complex_cubic (c3 V) (c2 V) (c1 V) (c0 V) s * x = 0)%C).
    { rewrite N; transitivity ((s + RtoC (V / D)) * (p * x + RtoC (b * V / D) * y) -
        RtoC (b * V / D) * ((s + RtoC (V / D)) * y + RtoC (/ V) * s * x))%C; [ring|]; rewrite S1, S2; ring. }
    assert (Y : (complex_cubic (c3 V) (c2 V) (c1 V) (c0 V) s * y = 0)%C).
    { rewrite N; transitivity (p * ((s + RtoC (V / D)) * y + RtoC (/ V) * s * x) -
        RtoC (/ V) * s * (p * x + RtoC (b * V / D) * y))%C; [ring|]; rewrite S1, S2; ring. }
    apply integral in X; destruct X as [X|X]; [exact X|]; apply integral in Y; destruct Y as [Y|Y]; [exact Y|].
    now destruct Z as [Z|Z]; elim Z.
  - intros Z; rewrite N in Z.
    exists (RtoC (b * V / D)), (- p)%C; split.
    + left; intros H; apply (f_equal fst) in H; simpl in H; assert (0 < b * V / D) by pos; lra.
    + apply D1; split; [ring|]; transitivity (- (p * (s + RtoC (V / D)) - RtoC (b * V / D) * (RtoC (/ V) * s)))%C; [ring|].
      rewrite Z; ring.
Qed.

End Friction.
