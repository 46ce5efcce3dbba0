(** The stability transition K = K_c of eq 8: claims S1 (its crossing pair), S3, S4, S6 and S7 of Im and Avouac. *)

From Slipmode Require Export Dimensionless Slider.

Section Transition.

Variables a b M : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (M_pos : 0 < M).

(** The coefficients of eq 8. *)
Let c3 (K D V sigma : R) := M / sigma.
Let c2 (K D V sigma : R) := a / V + M * V / (sigma * D).
Let c1 (K D V sigma : R) := K / sigma + (a - b) / D.
Let c0 (K D V sigma : R) := K * V / (sigma * D).
Let eq_8 (K D V sigma : R) := complex_cubic (c3 K D V sigma) (c2 K D V sigma) (c1 K D V sigma) (c0 K D V sigma).
Let grows (K D V sigma : R) := unstable (c3 K D V sigma) (c2 K D V sigma) (c1 K D V sigma) (c0 K D V sigma).

(** Eqs 9, 12 and 13. *)
Let K_c (D V sigma : R) := (b - a) * sigma / D * (1 + M * V ^ 2 / (sigma * a * D)).
Let sigma_c (K D : R) := K * D / (b - a).
Let V_c (K D : R) := D * sqrt (a / (b - a)) * sqrt (K / M).

Let unstable_below (K D V sigma : R) :
  0 < K -> 0 < D -> 0 < V -> 0 < sigma -> (grows K D V sigma <-> K < K_c D V sigma).
Proof using a_pos M_pos. intros k d v s; exact (proj1 (proj2 (S1 a b D K M sigma V a_pos d k M_pos s v))). Qed.

Let V_c_squared (K D : R) : a < b -> 0 < K -> V_c K D ^ 2 = D ^ 2 * a * K / ((b - a) * M).
Proof using a_pos M_pos.
  intros L k; assert (W : 0 < b - a) by lra; unfold V_c; rewrite !Rpow_mult_distr, !root_squared by (left; pos); field; split; lra.
Qed.

Let shares (K D V sigma : R) : a < b -> 0 < K -> 0 < D -> 0 < V -> 0 < sigma ->
  K_c D V sigma / K = sigma / sigma_c K D + (V / V_c K D) ^ 2.
Proof using a_pos M_pos.
  intros L k d v s; assert (W : 0 < b - a) by lra.
  assert (P : 0 < V_c K D) by (unfold V_c; pos).
  replace ((V / V_c K D) ^ 2) with (V ^ 2 / V_c K D ^ 2) by (field; lra); rewrite V_c_squared by assumption.
  unfold K_c, sigma_c; field; repeat split; lra.
Qed.

Let below (K D V sigma : R) : a < b -> 0 < K -> 0 < D -> 0 < V -> 0 < sigma ->
  (grows K D V sigma <-> 1 < sigma / sigma_c K D + (V / V_c K D) ^ 2).
Proof using a_pos M_pos.
  intros L k d v s; rewrite unstable_below, <- shares by assumption; split; intros H.
  - apply (Rmult_lt_reg_r K); [exact k|]; replace (K_c D V sigma / K * K) with (K_c D V sigma) by (field; lra); lra.
  - apply (Rmult_lt_compat_r K) in H; [|exact k]; replace (K_c D V sigma / K * K) with (K_c D V sigma) in H by (field; lra); lra.
Qed.

Let criticals_pos (K D : R) : a < b -> 0 < K -> 0 < D -> 0 < sigma_c K D /\ 0 < V_c K D.
Proof using a_pos M_pos. intros L k d; assert (W : 0 < b - a) by lra; unfold sigma_c, V_c; split; pos. Qed.

Let slow (x y : R) : 0 < x -> ((y / x) ^ 2 = y ^ 2 / x ^ 2)%R.
Proof using. intros H; field; lra. Qed.

(** Claim S3. *)
Theorem S3 (K D sigma : R) : 0 < K -> 0 < D -> 0 < sigma ->
  (a < b -> forall V, 0 < V -> (grows K D V sigma <-> V_c K D ^ 2 * (1 - sigma / sigma_c K D) < V ^ 2)) /\
  (a < b -> forall V W, 0 < V -> V < W -> K_c D V sigma < K_c D W sigma) /\
  (a < b -> filterlim (fun V => / K_c D V sigma) (Rbar_locally p_infty) (locally 0)) /\
  (b <= a -> forall V, 0 < V -> ~ grows K D V sigma).
Proof using a_pos M_pos.
  intros k d s; split; [|split; [|split]].
  - intros L V v; destruct (criticals_pos K D L k d) as [P Q]; rewrite below by assumption; rewrite slow by assumption.
    assert (Q2 : 0 < V_c K D ^ 2) by now apply pow_lt.
    set (x := V_c K D ^ 2) in *; set (r := sigma / sigma_c K D) in *; set (y := V ^ 2).
    assert (E : y = x * (y / x)) by (field; lra); split; intros H; [rewrite E; apply Rmult_lt_compat_l; lra|].
    rewrite E in H; apply Rmult_lt_reg_l in H; lra.
  - intros L V W v H; unfold K_c; apply Rmult_lt_compat_l; [assert (0 < b - a) by lra; pos|].
    apply Rplus_lt_compat_l; apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat; pos|].
    apply Rmult_lt_compat_l; [exact M_pos|]; nra.
  - intros L.
    assert (W : 0 < b - a) by lra; set (g := (b - a) * sigma / D).
    set (h := (b - a) * M / (a * D ^ 2)).
    assert (G : 0 < g) by (unfold g; pos); assert (H : 0 < h) by (unfold h; pos).
    apply (limit_at_infinity _ [0; 0; 1] [h; 0; g]); [|simpl; lra | simpl; field; lra].
    intros V v; replace (K_c D V sigma) with (g + h * V ^ 2) by (unfold K_c, g, h; field; repeat split; lra).
    assert (0 < h * V ^ 2) by pos; simpl; field; repeat split; lra.
  - intros L V v G; apply unstable_below in G; try assumption.
    assert (Z : K_c D V sigma <= 0); [|lra].
    unfold K_c; replace ((b - a) * sigma / D * (1 + M * V ^ 2 / (sigma * a * D)))
      with (- ((a - b) * (sigma / D * (1 + M * V ^ 2 / (sigma * a * D))))) by (field; repeat split; lra).
    assert (0 <= (a - b) * (sigma / D * (1 + M * V ^ 2 / (sigma * a * D)))); [|lra].
    apply Rmult_le_pos; [lra | left; pos].
Qed.

(** Claim S4. *)
Theorem S4 (K D : R) : a < b -> 0 < K -> 0 < D ->
  (forall V sigma, 0 < V -> 0 < sigma -> K_c D V sigma / K = sigma / sigma_c K D + (V / V_c K D) ^ 2) /\
  0 < sigma_c K D /\ 0 < V_c K D /\
  (forall V sigma, 0 < V -> 0 < sigma -> V_c K D <= V -> grows K D V sigma) /\
  (forall V sigma, 0 < V -> 0 < sigma -> sigma_c K D <= sigma -> grows K D V sigma) /\
  (forall V sigma, 0 < V -> 0 < sigma -> K = K_c D V sigma -> sigma = sigma_c K D * (1 - (V / V_c K D) ^ 2)) /\
  filterlim (fun V => sigma_c K D * (1 - (V / V_c K D) ^ 2)) (at_right 0) (locally (sigma_c K D)) /\
  filterlim (fun sigma => V_c K D ^ 2 * (1 - sigma / sigma_c K D)) (at_right 0) (locally (V_c K D ^ 2)).
Proof using a_pos M_pos.
  intros L k d; destruct (criticals_pos K D L k d) as [P Q].
  split; [intros; now apply shares|]; split; [exact P|]; split; [exact Q|].
  set (x := sigma_c K D) in *; set (y := V_c K D) in *.
  split; [|split; [|split; [|split]]].
  - intros V sigma v s H; apply below; try assumption; fold x y; rewrite slow by exact Q.
    assert (0 < sigma / x) by pos; assert (1 <= V ^ 2 / y ^ 2); [|lra].
    apply (Rmult_le_reg_r (y ^ 2)); [now apply pow_lt|]; replace (V ^ 2 / y ^ 2 * y ^ 2) with (V ^ 2) by (field; lra); nra.
  - intros V sigma v s H; apply below; try assumption; fold x y.
    assert (0 < (V / y) ^ 2) by (apply pow_lt; pos); assert (1 <= sigma / x); [|lra].
    apply (Rmult_le_reg_r x); [exact P|]; replace (sigma / x * x) with sigma by (field; lra); lra.
  - intros V sigma v s H; pose proof (shares K D V sigma L k d v s) as E; fold x y in E; rewrite <- H in E.
    replace (K / K) with 1 in E by (field; lra); replace ((V / y) ^ 2) with (1 - sigma / x) by lra; field; lra.
  - apply (limit_at_zero _ [x; 0; - x / y ^ 2] [1]); [intros V v; simpl; field; lra | simpl; lra | simpl; field; lra].
  - apply (limit_at_zero _ [y ^ 2; - y ^ 2 / x] [1]); [intros V v; simpl; field; lra | simpl; lra | simpl; field; lra].
Qed.

(** Claim S6: on K = K_c eq 8 falls into the pair of eq 23 and a real root. *)
Theorem S6 (D V sigma : R) (s : C) : 0 < D -> 0 < V -> 0 < sigma -> a < b ->
  let omega := sqrt ((b - a) / a) * V / D in
  eq_8 (K_c D V sigma) D V sigma s =
    ((s - Ci * RtoC omega) * (s + Ci * RtoC omega) * (RtoC (M / sigma) * s + RtoC (a / V + M * V / (sigma * D))))%C.
Proof using a_pos M_pos.
  intros d v w L omega.
  assert (E : omega * omega = (b - a) / a * V ^ 2 / D ^ 2).
  { unfold omega; replace (sqrt ((b - a) / a) * V / D * (sqrt ((b - a) / a) * V / D))
      with (sqrt ((b - a) / a) ^ 2 * V ^ 2 / D ^ 2) by (field; lra).
    rewrite root_squared; [reflexivity | left; apply Rdiv_lt_0_compat; lra]. }
  replace ((s - Ci * RtoC omega) * (s + Ci * RtoC omega))%C with (s * s + RtoC (omega * omega))%C
    by (destruct s as [x y]; project; ring).
  rewrite E; unfold eq_8, c3, c2, c1, c0, K_c, complex_cubic; destruct s as [x y]; project; field; repeat split; lra.
Qed.

(** Claim S7. *)
Theorem S7 (K V sigma : R) : 0 < K -> 0 < V -> 0 < sigma -> a < b ->
  filterlim (fun D => sigma_c K D) (at_right 0) (locally 0) /\
  filterlim (fun D => V_c K D) (at_right 0) (locally 0) /\
  (forall D, 0 < D -> D < (b - a) * sigma / K -> grows K D V sigma) /\
  (forall D E, 0 < D -> D < E -> K_c E V sigma < K_c D V sigma).
Proof using a_pos M_pos.
  intros k v s L; assert (W : 0 < b - a) by lra; split; [|split; [|split]].
  - apply (limit_at_zero _ [0; K] [b - a]); [intros D d; unfold sigma_c; simpl; field; lra | simpl; lra | simpl; field; lra].
  - apply (limit_at_zero _ [0; sqrt (a / (b - a)) * sqrt (K / M)] [1]);
      [intros D d; unfold V_c; simpl; field | simpl; lra | simpl; field].
  - intros D d H; apply unstable_below; try assumption; unfold K_c.
    assert (E : K < (b - a) * sigma / D).
    { apply (Rmult_lt_reg_r D); [exact d|]; replace ((b - a) * sigma / D * D) with ((b - a) * sigma) by (field; lra).
      apply (Rmult_lt_compat_r K) in H; [|exact k]; replace ((b - a) * sigma / K * K) with ((b - a) * sigma) in H by (field; lra); lra. }
    assert (0 < (b - a) * sigma / D * (M * V ^ 2 / (sigma * a * D))) by pos; lra.
  - intros D E d H; unfold K_c; assert (I : / E < / D) by (apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | lra]).
    assert (I0 : 0 < / E) by (apply Rinv_0_lt_compat; lra).
    replace ((b - a) * sigma / E * (1 + M * V ^ 2 / (sigma * a * E)))
      with ((b - a) * sigma * / E + (b - a) * M * V ^ 2 / a * (/ E * / E)) by (field; repeat split; lra).
    replace ((b - a) * sigma / D * (1 + M * V ^ 2 / (sigma * a * D)))
      with ((b - a) * sigma * / D + (b - a) * M * V ^ 2 / a * (/ D * / D)) by (field; repeat split; lra).
    apply Rplus_lt_compat; apply Rmult_lt_compat_l; try pos; try assumption; apply Rmult_le_0_lt_compat; lra.
Qed.

(** The pair of claim S1 crosses the imaginary axis at K = K_c with a speed that is not zero: on a curve of roots t + i w(t), K
    falls with t at a rate k' < 0. *)
Theorem S1_crossing (D V sigma : R) : 0 < D -> 0 < V -> 0 < sigma -> a < b ->
  exists (e : R) (k w : R -> R) (k' : R), 0 < e /\ k' < 0 /\ is_derive k 0 k' /\ continuous w 0 /\
    k 0 = K_c D V sigma /\ w 0 = sqrt ((b - a) / a) * V / D /\
    forall t, Rabs t < e -> 0 < k t /\ 0 < w t /\ eq_8 (k t) D V sigma (t, w t) = 0%C.
Proof using a_pos b_pos M_pos.
  intros d v s L.
  set (eta := M * V ^ 2 / (sigma * a * D)); set (beta := b / a).
  assert (E : 0 < eta) by (unfold eta; pos); assert (B : 0 < beta) by (unfold beta; pos).
  assert (B1 : 1 < beta).
  { unfold beta; apply (Rmult_lt_reg_r a); [exact a_pos|]; replace (b / a * a) with b by (field; lra); lra. }
  assert (F : 0 < V / D) by pos; assert (G : 0 < D / V) by pos.
  (* By the real part p of the dimensionless root. *)
  set (y := fun p => / eta + 2 * p); set (P := fun p => beta - 2 * beta * p / y p).
  set (q := fun p => P p - (2 + 2 * p) + 1 - p ^ 2).
  set (kappa := fun p => eta * (1 + y p) * (P p - (2 + 2 * p) + 1)).
  assert (Y0 : 0 < / eta) by now apply Rinv_0_lt_compat.
  assert (CP : continuous P 0).
  { apply (ex_derive_continuous P); unfold P, y; auto_derive; lra. }
  assert (CQ : continuous q 0).
  { apply (ex_derive_continuous q); unfold q, P, y; auto_derive; lra. }
  assert (Q0 : q 0 = beta - 1) by (unfold q, P, y; field; repeat split; lra).
  assert (N : exists r, 0 < r /\ forall p, Rabs p < r -> 0 < y p /\ 0 < q p).
  { destruct (CQ (fun x => 0 < x)) as [r RR].
    { rewrite Q0; exists (mkposreal (beta - 1) ltac:(lra)); intros x X; unfold ball in X; simpl in X;
        unfold AbsRing_ball, abs, minus, plus, opp in X; simpl in X; apply Rabs_def2 in X; lra. }
    exists (Rmin r (/ eta / 2)); split; [apply Rmin_pos; [apply cond_pos | lra]|]; intros p X.
    pose proof (Rmin_l r (/ eta / 2)); pose proof (Rmin_r r (/ eta / 2)); split.
    - unfold y; apply Rabs_def2 in X; lra.
    - apply RR; unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl; rewrite Ropp_0, Rplus_0_r; lra. }
  destruct N as (r & R0 & RR).
  exists (V / D * r), (fun t => a * sigma / D * kappa (D / V * t)), (fun t => V / D * sqrt (q (D / V * t))),
    (a * sigma / D * (D / V * (- 2 * (beta * eta ^ 2 + 2 * eta + 1)))).
  assert (K0 : kappa 0 = (beta - 1) * (1 + eta)) by (unfold kappa, P, y; field; repeat split; lra).
  split; [apply Rmult_lt_0_compat; assumption|]; split.
  { assert (0 < a * sigma / D * (D / V * (2 * (beta * eta ^ 2 + 2 * eta + 1)))) by pos; lra. }
  split.
  { unfold kappa, P, y; auto_derive; [rewrite Rmult_0_r; lra|].
    match goal with |- ?u = ?v => change (u = v :> R) end; rewrite Rmult_0_r; field; repeat split; lra. }
  split.
  { apply (continuous_mult (fun _ => V / D) (fun t => sqrt (q (D / V * t)))); [apply continuous_const|].
    apply (continuous_comp (fun t => q (D / V * t)) sqrt); [|apply continuous_sqrt].
    apply (continuous_comp (fun t => D / V * t) q).
    - apply (continuous_mult (fun _ => D / V) (fun t => t)); [apply continuous_const | apply continuous_id].
    - rewrite Rmult_0_r; exact CQ. }
  rewrite !Rmult_0_r, K0, Q0; split; [|split].
  - unfold K_c, eta, beta; field; repeat split; lra.
  - replace (beta - 1) with ((b - a) / a) by (unfold beta; field; lra); field; lra.
  - intros t T; set (p := D / V * t).
    assert (T' : Rabs p < r).
    { unfold p; rewrite Rabs_mult, (Rabs_pos_eq (D / V)) by lra; apply (Rmult_lt_reg_l (V / D)); [exact F|].
      replace (V / D * (D / V * Rabs t)) with (Rabs t) by (field; lra); exact T. }
    destruct (RR p T') as [Yp Qp].
    assert (Kp : 0 < kappa p).
    { unfold kappa; assert (0 < P p - (2 + 2 * p) + 1) by (unfold q in Qp; pose proof (pow2_ge_0 p); lra).
      apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | assumption]. }
    assert (TT : parts eta (kappa p) beta (y p) (2 + 2 * p) (P p)).
    { split; [exact Yp|]; split; [unfold P; field; lra | split; [unfold y; field; lra | reflexivity]]. }
    assert (H1 : 0 < a * sigma / D * kappa p) by (apply Rmult_lt_0_compat; [pos | exact Kp]).
    split; [exact H1|]; split; [apply Rmult_lt_0_compat; [exact F | now apply sqrt_lt_R0]|].
    replace (t, V / D * sqrt (q p)) with (RtoC (V / D) * (p, sqrt (q p)))%C
      by (unfold p; project; field; repeat split; lra).
    unfold eq_8, c3, c2, c1, c0; apply (groups a b D (a * sigma / D * kappa p) M V sigma); try assumption; fold eta beta.
    replace (a * sigma / D * kappa p * D / (a * sigma)) with (kappa p) by (field; repeat split; lra).
    apply (roots _ _ _ _ _ _ E TT); right; apply quadratic_parts.
    rewrite root_squared by lra; split; [unfold q; ring | ring].
Qed.

End Transition.
