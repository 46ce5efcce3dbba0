(** The boundary of max Im(s) = 0, on which two roots of eq 8 are equal: a curve of the double root r, its cusp, and its four
    ends, which are eqs 15, 16, 18 and 20: claims B2, B3, B4, B5 and B10 of Im and Avouac. *)

From Slipmode Require Export Dimensionless.

(** ** The curve in the dimensionless groups *)

Definition eta_at (beta r : R) : R := (beta - (r + 1) ^ 2) / (2 * r * (r + 1) ^ 2).
Definition kappa_at (beta r : R) : R := r * ((2 * r + 1) * beta - (r + 1) ^ 2) / (2 * (r + 1) ^ 2).

(** A double root r. *)
Definition twice (eta kappa beta r : R) : Prop :=
  cubic eta (1 + eta) (kappa + 1 - beta) kappa r = 0 /\ 3 * eta * r ^ 2 + 2 * (1 + eta) * r + (kappa + 1 - beta) = 0.

Theorem boundary_curve (eta kappa beta r : R) :
  0 < kappa -> 0 < beta ->
  (twice eta kappa beta r <-> r <> 0 /\ r <> - 1 /\ eta = eta_at beta r /\ kappa = kappa_at beta r).
Proof.
  intros Q B; unfold twice, cubic, eta_at, kappa_at; split.
  - intros [H1 H2].
    assert (N0 : r <> 0) by (intros ->; lra).
    assert (N1 : r <> - 1) by (intros ->; lra).
    assert (N2 : r + 1 <> 0) by lra.
    split; [exact N0|]; split; [exact N1|].
    assert (E : 2 * r * (r + 1) ^ 2 * eta = beta - (r + 1) ^ 2) by nra.
    assert (E' : 2 * (r + 1) ^ 2 * kappa = r * ((2 * r + 1) * beta - (r + 1) ^ 2)) by nra.
    split; [rewrite <- E | rewrite <- E']; field; [split|]; assumption.
  - intros (N0 & N1 & -> & ->); assert (N2 : r + 1 <> 0) by lra; split; field; split; assumption.
Qed.

(** Where the curve has positive groups: two arcs of r, for β = w². *)
Theorem arcs (w r : R) :
  0 < w -> r <> 0 -> r <> - 1 ->
  (0 < eta_at (w ^ 2) r /\ 0 < kappa_at (w ^ 2) r <-> 0 < r < w - 1 \/ w - 1 < r < 0 \/ r < - 1 - w).
Proof.
  intros W N0 N1; unfold eta_at, kappa_at.
  assert (S : 0 < (r + 1) ^ 2) by (apply pow2_gt_0; lra).
  set (m := (r + 1) ^ 2) in *.
  assert (E : (w ^ 2 - m) / (2 * r * m) * (2 * r ^ 2 * m) = r * (w ^ 2 - m)) by (field; lra).
  assert (E' : r * ((2 * r + 1) * w ^ 2 - m) / (2 * m) * (2 * m) = r * ((2 * r + 1) * w ^ 2 - m)) by (field; lra).
  assert (R2 : 0 < r ^ 2) by now apply pow2_gt_0.
  assert (P : 0 < 2 * r ^ 2 * m) by (apply Rmult_lt_0_compat; lra).
  assert (W2 : 0 < w ^ 2) by now apply pow_lt.
  split.
  - intros [H _].
    assert (G : 0 < r * (w ^ 2 - m)) by (rewrite <- E; now apply Rmult_lt_0_compat).
    unfold m in G.
    destruct (Rdichotomy _ _ N0) as [L|L].
    + assert (w ^ 2 < (r + 1) ^ 2) by nra.
      destruct (Rlt_le_dec w (r + 1)); [right; left; lra|]; right; right.
      destruct (Rlt_le_dec r (- 1 - w)); [assumption | exfalso; nra].
    + assert ((r + 1) ^ 2 < w ^ 2) by nra.
      left; split; [exact L|]; destruct (Rlt_le_dec r (w - 1)); [assumption | exfalso; nra].
  - intros H.
    assert (G : 0 < r * (w ^ 2 - m)).
    { unfold m; destruct H as [H|[H|H]].
      - apply Rmult_lt_0_compat; [lra|]; nra.
      - replace (r * (w ^ 2 - (r + 1) ^ 2)) with (- r * ((r + 1) ^ 2 - w ^ 2)) by ring.
        apply Rmult_lt_0_compat; nra.
      - replace (r * (w ^ 2 - (r + 1) ^ 2)) with (- r * ((r + 1) ^ 2 - w ^ 2)) by ring.
        apply Rmult_lt_0_compat; nra. }
    split; apply (Rmult_lt_reg_r (2 * r ^ 2 * m)); try exact P; rewrite Rmult_0_l; [rewrite E; exact G|].
    replace (r * ((2 * r + 1) * w ^ 2 - m) / (2 * m) * (2 * r ^ 2 * m)) with (r ^ 2 * (r * (w ^ 2 - m) + 2 * r ^ 2 * w ^ 2))
      by (field; lra).
    apply Rmult_lt_0_compat; [exact R2|]; assert (0 < r ^ 2 * w ^ 2) by now apply Rmult_lt_0_compat.
    lra.
Qed.

(** Along the curve the slope dκ/dη is −r². *)
Theorem envelope (beta r : R) :
  r <> 0 -> r <> - 1 -> exists e k : R, is_derive (eta_at beta) r e /\ is_derive (kappa_at beta) r k /\ k = - r ^ 2 * e.
Proof.
  intros N0 N1; assert (N2 : r + 1 <> 0) by lra.
  assert (N : 2 * r * (r + 1) ^ 2 <> 0) by (repeat apply Rmult_integral_contrapositive_currified; try lra; now apply pow_nonzero).
  assert (N' : 2 * (r + 1) ^ 2 <> 0) by (apply Rmult_integral_contrapositive_currified; [lra | now apply pow_nonzero]).
  eexists; eexists; split; [|split].
  - unfold eta_at; auto_derive; [exact N | reflexivity].
  - unfold kappa_at; auto_derive; [exact N' | reflexivity].
  - cbv beta; field; repeat split; assumption.
Qed.

(** ** The cusp *)

(** A triple root r: two equations of a double root, and the second derivative. *)
Definition thrice (eta kappa beta r : R) : Prop := twice eta kappa beta r /\ 6 * eta * r + 2 * (1 + eta) = 0.

Theorem cusp (eta kappa beta r : R) :
  0 < eta -> 0 < kappa -> 0 < beta ->
  (thrice eta kappa beta r <->
   r < - 1 /\ (r + 1) ^ 3 = beta * (3 * r + 1) /\ eta = - 1 / (3 * r + 1) /\ kappa = r ^ 3 / (3 * r + 1)).
Proof.
  intros E Q B; unfold thrice, twice, cubic; split.
  - intros [[H1 H2] H3].
    assert (T : eta * (3 * r + 1) = - 1) by lra.
    assert (T' : 3 * r + 1 < 0) by (destruct (Rlt_le_dec (3 * r + 1) 0); [assumption | nra]).
    assert (K' : kappa = - eta * r ^ 3) by nra.
    assert (R : r < 0) by lra.
    assert (C : (r + 1) ^ 3 = beta * (3 * r + 1)).
    { assert (B' : beta = kappa + 1 + 3 * eta * r ^ 2 + 2 * (1 + eta) * r) by lra.
      rewrite B', K'; replace ((- eta * r ^ 3 + 1 + 3 * eta * r ^ 2 + 2 * (1 + eta) * r) * (3 * r + 1))
        with (eta * (3 * r + 1) * (- r ^ 3 + 3 * r ^ 2 + 2 * r) + (1 + 2 * r) * (3 * r + 1)) by ring.
      rewrite T; ring. }
    split; [|split; [exact C|split]].
    + assert (N : (r + 1) ^ 3 < 0) by (rewrite C; nra).
      destruct (Rlt_le_dec r (- 1)) as [|L]; [assumption|]; exfalso.
      assert (0 <= (r + 1) ^ 3) by (apply pow_le; lra); lra.
    + rewrite <- T; field; lra.
    + rewrite K'; replace (- eta * r ^ 3) with (eta * (3 * r + 1) * - r ^ 3 / (3 * r + 1)) by (field; lra).
      rewrite T; field; lra.
  - intros (R & C & -> & ->).
    assert (B' : beta = (r + 1) ^ 3 / (3 * r + 1)) by (rewrite C; field; lra).
    rewrite B'; repeat split; field; lra.
Qed.

(** There is exactly one triple root for every β. *)
Theorem one_cusp (beta : R) :
  0 < beta -> exists r, r < - 1 /\ (r + 1) ^ 3 = beta * (3 * r + 1) /\
    forall q, q < - 1 -> (q + 1) ^ 3 = beta * (3 * q + 1) -> q = r.
Proof.
  intros B.
  destruct (root_above (fun x => x ^ 3 - 3 * beta * x - 2 * beta) [- 2 * beta; - 3 * beta; 0; 1] 0) as (x & X & Z).
  { intros s; simpl; ring. }
  { right; simpl; lra. }
  exists (- 1 - x); split; [lra|]; split; [replace (- 1 - x + 1) with (- x) by ring; nra|].
  intros q Q E; set (y := - 1 - q); assert (Y : 0 < y) by (unfold y; lra).
  replace q with (- 1 - y) in E by (unfold y; ring).
  assert (E' : y ^ 3 - 3 * beta * y - 2 * beta = 0) by lra.
  assert (D : (y - x) * (3 * (x * y) * (x + y) + 2 * (x ^ 2 + x * y + y ^ 2)) = 0).
  { assert (B1 : beta * (3 * x + 2) = x ^ 3) by lra; assert (B2 : beta * (3 * y + 2) = y ^ 3) by lra.
    transitivity (y ^ 3 * (3 * x + 2) - x ^ 3 * (3 * y + 2)); [ring | rewrite <- B1, <- B2; ring]. }
  apply Rmult_integral in D; destruct D as [D|D]; [unfold y in *; lra|].
  assert (0 < x * y) by now apply Rmult_lt_0_compat.
  exfalso; assert (0 < x * y * (x + y)) by (apply Rmult_lt_0_compat; lra); nra.
Qed.

(** ** Limits along the curve *)

(** The product of the groups along the curve, which eqs 18 and 20 are about. *)
Lemma product_at (beta r : R) :
  r <> 0 -> r <> - 1 ->
  eta_at beta r * kappa_at beta r = (beta - (r + 1) ^ 2) * ((2 * r + 1) * beta - (r + 1) ^ 2) / (4 * (r + 1) ^ 4).
Proof. intros N0 N1; unfold eta_at, kappa_at; field; split; lra. Qed.

Lemma eta_continuous (beta r : R) : r <> 0 -> r <> - 1 -> continuous (eta_at beta) r.
Proof. intros N0 N1; destruct (envelope beta r N0 N1) as (e & k & H & _); apply (ex_derive_continuous (eta_at beta)); now exists e. Qed.

Lemma kappa_continuous (beta r : R) : r <> - 1 -> continuous (kappa_at beta) r.
Proof.
  intros N; apply (ex_derive_continuous (kappa_at beta)); unfold kappa_at; auto_derive.
  apply Rmult_integral_contrapositive_currified; [lra|]; rewrite Rmult_1_r; apply Rmult_integral_contrapositive_currified; lra.
Qed.

Section Plane.

Variables a b D K M : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M).

(** The coefficients of eq 8. *)
Let c3 (V sigma : R) := M / sigma.
Let c2 (V sigma : R) := a / V + M * V / (sigma * D).
Let c1 (V sigma : R) := K / sigma + (a - b) / D.
Let c0 (V sigma : R) := K * V / (sigma * D).

(** Eqs 15 and 16, and the left sides of eqs 18 and 20. *)
Let right_15 := K * D / (sqrt (b) - sqrt (a)) ^ 2.
Let right_16 := K * D / (sqrt (b) + sqrt (a)) ^ 2.
Let left_18 (V sigma : R) := 2 * V * sqrt (M * K) / (Rabs (a - b) * sigma).
Let left_20 (V sigma : R) := 2 * V * sqrt (M * K) / (a * sigma).

(** Two roots of eq 8 are equal. *)
Let boundary (V sigma : R) :=
  0 < V /\ 0 < sigma /\ discriminant (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma) = 0.

Let w := sqrt (b / a).

(** The point of the curve. *)
Let V_at (r : R) := D * sqrt (eta_at (b / a) r * K / (kappa_at (b / a) r * M)).
Let sigma_at (r : R) := K * D / (a * kappa_at (b / a) r).

Let w_pos : 0 < w.
Proof using a_pos b_pos. unfold w; apply sqrt_lt_R0; pos. Qed.

Let w_squared : w ^ 2 = b / a.
Proof using a_pos b_pos. unfold w; apply root_squared; left; pos. Qed.

Let on_arc (r : R) := 0 < r < w - 1 \/ w - 1 < r < 0 \/ r < - 1 - w.

Let groups_pos (r : R) : on_arc r -> r <> 0 /\ r <> - 1 /\ 0 < eta_at (b / a) r /\ 0 < kappa_at (b / a) r.
Proof using a_pos b_pos.
  intros H; pose proof w_pos as W.
  assert (N0 : r <> 0) by (destruct H as [H|[H|H]]; lra).
  assert (N1 : r <> - 1) by (destruct H as [H|[H|H]]; lra).
  split; [exact N0|]; split; [exact N1|]; rewrite <- w_squared; now apply arcs.
Qed.

(** The double root at a point of the curve. *)
Let double_at (r : R) : on_arc r ->
  0 < V_at r /\ 0 < sigma_at r /\
  cubic (c3 (V_at r) (sigma_at r)) (c2 (V_at r) (sigma_at r)) (c1 (V_at r) (sigma_at r)) (c0 (V_at r) (sigma_at r)) (V_at r / D * r) = 0 /\
  3 * c3 (V_at r) (sigma_at r) * (V_at r / D * r) ^ 2 + 2 * c2 (V_at r) (sigma_at r) * (V_at r / D * r) + c1 (V_at r) (sigma_at r) = 0.
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros A; destruct (groups_pos r A) as (N0 & N1 & E & Q).
  set (beta := b / a) in *; set (e := eta_at beta r) in *; set (k := kappa_at beta r) in *.
  assert (B : 0 < beta) by (unfold beta; pos).
  assert (P : 0 < e * K / (k * M)) by pos.
  assert (v : 0 < V_at r) by (unfold V_at; fold beta e k; pos).
  assert (s : 0 < sigma_at r) by (unfold sigma_at; fold beta k; pos).
  split; [exact v|]; split; [exact s|].
  assert (EE : M * V_at r ^ 2 / (sigma_at r * a * D) = e).
  { unfold V_at, sigma_at; fold beta e k; rewrite Rpow_mult_distr, root_squared by lra.
    field; repeat split; apply Rgt_not_eq; assumption. }
  assert (EK : K * D / (a * sigma_at r) = k).
  { unfold sigma_at; fold beta k; field; repeat split; apply Rgt_not_eq; assumption. }
  assert (T : twice e k beta r) by (apply boundary_curve; repeat split; assumption).
  destruct T as [T1 T2]; set (V := V_at r) in *; set (sigma := sigma_at r) in *.
  split.
  + replace (cubic (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma) (V / D * r))
      with (a * V / D ^ 2 * cubic e (1 + e) (k + 1 - beta) k r)
      by (rewrite <- EE, <- EK; unfold cubic, c3, c2, c1, c0, beta; field; repeat split; apply Rgt_not_eq; assumption).
    rewrite T1; ring.
  + replace (3 * c3 V sigma * (V / D * r) ^ 2 + 2 * c2 V sigma * (V / D * r) + c1 V sigma)
      with (a / D * (3 * e * r ^ 2 + 2 * (1 + e) * r + (k + 1 - beta)))
      by (rewrite <- EE, <- EK; unfold c3, c2, c1, beta; field; repeat split; apply Rgt_not_eq; assumption).
    rewrite T2; ring.
Qed.

(** The boundary is the curve: every point of it, and nothing else. *)
Theorem boundary_is_curve (V sigma : R) : boundary V sigma <-> exists r, on_arc r /\ V = V_at r /\ sigma = sigma_at r.
Proof using a_pos b_pos D_pos K_pos M_pos.
  pose proof w_pos as W; split.
  - intros (v & s & H); apply double_root in H; [|unfold c3; apply Rgt_not_eq; red; pos].
    destruct H as (z & H1 & H2).
    set (eta := M * V ^ 2 / (sigma * a * D)); set (kappa := K * D / (a * sigma)).
    assert (E : 0 < eta) by (unfold eta; pos); assert (Q : 0 < kappa) by (unfold kappa; pos).
    assert (B : 0 < b / a) by pos.
    assert (T : twice eta kappa (b / a) (D / V * z)).
    { split.
      - replace (cubic eta (1 + eta) (kappa + 1 - b / a) kappa (D / V * z))
          with (D ^ 2 / (a * V) * cubic (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma) z)
          by (unfold cubic, c3, c2, c1, c0, eta, kappa; field; repeat split; apply Rgt_not_eq; assumption).
        rewrite H1; ring.
      - replace (3 * eta * (D / V * z) ^ 2 + 2 * (1 + eta) * (D / V * z) + (kappa + 1 - b / a))
          with (D / a * (3 * c3 V sigma * z ^ 2 + 2 * c2 V sigma * z + c1 V sigma))
          by (unfold c3, c2, c1, c0, eta, kappa; field; repeat split; apply Rgt_not_eq; assumption).
        rewrite H2; ring. }
    apply boundary_curve in T; [|assumption|assumption]; destruct T as (N0 & N1 & EE & EK).
    exists (D / V * z); split; [|split].
    + apply (arcs w _ W N0 N1); rewrite w_squared, <- EE, <- EK; now split.
    + unfold V_at; rewrite <- EE, <- EK; unfold eta, kappa.
      replace (M * V ^ 2 / (sigma * a * D) * K / (K * D / (a * sigma) * M)) with (V / D * (V / D))
        by (field; repeat split; apply Rgt_not_eq; assumption).
      rewrite sqrt_square by (left; pos); field; apply Rgt_not_eq; assumption.
    + unfold sigma_at; rewrite <- EK; unfold kappa; field; repeat split; apply Rgt_not_eq; assumption.
  - intros (r & A & -> & ->); destruct (double_at r A) as (v & s & Z).
    split; [exact v|]; split; [exact s|]; apply double_root; [unfold c3; apply Rgt_not_eq; red; pos | now exists (V_at r / D * r)].
Qed.

(** Eqs 18 and 20 along the curve. *)
Let root_of_product (r c : R) :
  on_arc r -> 0 < c ->
  2 * V_at r * sqrt (M * K) / (c * sigma_at r) = 2 * a / c * sqrt (eta_at (b / a) r * kappa_at (b / a) r).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros A C; destruct (groups_pos r A) as (N0 & N1 & E & Q); unfold V_at, sigma_at.
  set (e := eta_at (b / a) r) in *; set (k := kappa_at (b / a) r) in *.
  assert (H : sqrt (e * K / (k * M)) * sqrt (M * K) = K / k * sqrt (e * k)).
  { rewrite <- sqrt_mult by (left; pos).
    replace (e * K / (k * M) * (M * K)) with (K / k * (K / k) * (e * k)) by (field; lra).
    rewrite sqrt_mult by (left; pos); rewrite sqrt_square by (left; pos); reflexivity. }
  replace (2 * (D * sqrt (e * K / (k * M))) * sqrt (M * K) / (c * (K * D / (a * k))))
    with (2 * a * k / (c * K) * (sqrt (e * K / (k * M)) * sqrt (M * K))) by (field; repeat split; apply Rgt_not_eq; assumption).
  rewrite H; field; repeat split; apply Rgt_not_eq; assumption.
Qed.

Let roots_of_ab : sqrt b = w * sqrt a.
Proof using a_pos b_pos.
  unfold w; rewrite <- sqrt_mult by (left; pos); f_equal; field; lra.
Qed.

(** At r = ±w − 1 the curve reaches V = 0 at a finite stress. *)
Let ends_at_rest (r l : R) :
  r <> 0 -> r <> - 1 -> eta_at (b / a) r = 0 -> kappa_at (b / a) r <> 0 -> K * D / (a * kappa_at (b / a) r) = l ->
  filterlim V_at (locally r) (locally 0) /\ filterlim sigma_at (locally r) (locally l).
Proof using M_pos a_pos.
  intros N0 N1 E N <-.
  assert (CE : continuous (eta_at (b / a)) r) by now apply eta_continuous.
  assert (CK : continuous (kappa_at (b / a)) r) by now apply kappa_continuous.
  split.
  - replace 0 with (V_at r) by (unfold V_at; rewrite E; replace (0 * K / (kappa_at (b / a) r * M)) with 0 by (field; lra); rewrite sqrt_0; ring).
    change (continuous V_at r).
    apply (continuous_mult (fun _ => D) (fun r => sqrt (eta_at (b / a) r * K / (kappa_at (b / a) r * M)))); [apply continuous_const|].
    apply (continuous_comp (fun r => eta_at (b / a) r * K / (kappa_at (b / a) r * M)) sqrt); [|apply continuous_sqrt].
    apply (continuous_mult (fun r => eta_at (b / a) r * K) (fun r => / (kappa_at (b / a) r * M))).
    + apply (continuous_mult (eta_at (b / a)) (fun _ => K)); [exact CE | apply continuous_const].
    + apply (continuous_comp (fun r => kappa_at (b / a) r * M) Rinv).
      * apply (continuous_mult (kappa_at (b / a)) (fun _ => M)); [exact CK | apply continuous_const].
      * apply continuous_Rinv, Rmult_integral_contrapositive_currified; lra.
  - change (continuous sigma_at r).
    apply (continuous_mult (fun _ => K * D) (fun r => / (a * kappa_at (b / a) r))); [apply continuous_const|].
    apply (continuous_comp (fun r => a * kappa_at (b / a) r) Rinv).
    + apply (continuous_mult (fun _ => a) (kappa_at (b / a))); [apply continuous_const | exact CK].
    + apply continuous_Rinv, Rmult_integral_contrapositive_currified; lra.
Qed.

(** The upper arc tends to eq 15 where r tends to w − 1, for a <> b. *)
Theorem end_15 : a <> b ->
  filterlim V_at (locally (w - 1)) (locally 0) /\ filterlim sigma_at (locally (w - 1)) (locally right_15).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros N; pose proof w_pos as W.
  assert (W1 : w <> 1).
  { intros E; apply N; pose proof w_squared as S; rewrite E in S; apply (Rmult_eq_reg_r (/ a)); [|apply Rinv_neq_0_compat; lra].
    unfold Rdiv in S; rewrite <- S; field; lra. }
  assert (K1 : kappa_at (b / a) (w - 1) = (w - 1) ^ 2) by (rewrite <- w_squared; unfold kappa_at; field; lra).
  assert (K0 : (w - 1) ^ 2 <> 0) by (apply pow_nonzero; lra).
  apply ends_at_rest; [lra | lra | | rewrite K1; exact K0 |].
  - rewrite <- w_squared; unfold eta_at; field; split; lra.
  - rewrite K1; unfold right_15; rewrite roots_of_ab.
    replace ((w * sqrt a - sqrt a) ^ 2) with (sqrt a ^ 2 * (w - 1) ^ 2) by ring.
    rewrite root_squared by lra; reflexivity.
Qed.

(** The lower arc tends to eq 16 where r tends to −1 − w. *)
Theorem end_16 :
  filterlim V_at (locally (- 1 - w)) (locally 0) /\ filterlim sigma_at (locally (- 1 - w)) (locally right_16).
Proof using a_pos b_pos D_pos K_pos M_pos.
  pose proof w_pos as W.
  assert (K1 : kappa_at (b / a) (- 1 - w) = (w + 1) ^ 2) by (rewrite <- w_squared; unfold kappa_at; field; lra).
  assert (K0 : (w + 1) ^ 2 <> 0) by (apply pow_nonzero; lra).
  apply ends_at_rest; [lra | lra | | rewrite K1; exact K0 |].
  - rewrite <- w_squared; unfold eta_at; field; split; lra.
  - rewrite K1; unfold right_16; rewrite roots_of_ab.
    replace ((w * sqrt a + sqrt a) ^ 2) with (sqrt a ^ 2 * (w + 1) ^ 2) by ring.
    rewrite root_squared by lra; reflexivity.
Qed.

Let product (r : R) := (b / a - (r + 1) ^ 2) * ((2 * r + 1) * (b / a) - (r + 1) ^ 2) / (4 * (r + 1) ^ 4).

(** The upper arc tends to eq 18 where r tends to 0, while σ grows beyond every bound. *)
Theorem end_18 : a <> b ->
  filterlim (fun r => left_18 (V_at r) (sigma_at r)) (within on_arc (locally 0)) (locally 1) /\
  filterlim (fun r => / sigma_at r) (within on_arc (locally 0)) (locally 0).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros N; assert (C : 0 < Rabs (a - b)) by (apply Rabs_pos_lt; lra).
  split.
  - apply filterlim_ext_loc with (f := fun r => 2 * a / Rabs (a - b) * sqrt (product r)).
    + unfold within; apply filter_forall; intros r A; unfold left_18; rewrite root_of_product by assumption.
      destruct (groups_pos r A) as (N0 & N1 & _); unfold product; rewrite <- product_at by assumption; reflexivity.
    + eapply filterlim_filter_le_1; [apply filter_le_within|].
      replace 1 with (2 * a / Rabs (a - b) * sqrt (product 0)).
      * change (continuous (fun r => 2 * a / Rabs (a - b) * sqrt (product r)) 0).
        apply (continuous_mult (fun _ => 2 * a / Rabs (a - b)) (fun r => sqrt (product r))); [apply continuous_const|].
        apply (continuous_comp product sqrt); [|apply continuous_sqrt].
        apply (ex_derive_continuous product); unfold product; auto_derive; lra.
      * replace (product 0) with (Rabs (a - b) / (2 * a) * (Rabs (a - b) / (2 * a))).
        { rewrite sqrt_square by (left; pos); field; split; lra. }
        unfold product; replace (Rabs (a - b) / (2 * a) * (Rabs (a - b) / (2 * a))) with (Rabs (a - b) ^ 2 / (4 * a ^ 2)) by (field; lra).
        rewrite pow2_abs; field; lra.
  - apply filterlim_ext_loc with (f := fun r => a * kappa_at (b / a) r / (K * D)).
    + unfold within; apply filter_forall; intros r A; destruct (groups_pos r A) as (_ & _ & _ & Q); unfold sigma_at.
      field; repeat split; apply Rgt_not_eq; assumption.
    + eapply filterlim_filter_le_1; [apply filter_le_within|].
      replace 0 with (a * kappa_at (b / a) 0 / (K * D)) at 2 by (unfold kappa_at; field; repeat split; apply Rgt_not_eq; assumption).
      change (continuous (fun r => a * kappa_at (b / a) r / (K * D)) 0).
      apply (continuous_mult (fun r => a * kappa_at (b / a) r) (fun _ => / (K * D))); [|apply continuous_const].
      apply (continuous_mult (fun _ => a) (kappa_at (b / a))); [apply continuous_const|].
      apply kappa_continuous; lra.
Qed.

(** The lower arc tends to eq 20 where r tends to −∞, while σ tends to 0. *)
Theorem end_20 :
  filterlim (fun r => left_20 (V_at r) (sigma_at r)) (Rbar_locally m_infty) (locally 1) /\
  filterlim sigma_at (Rbar_locally m_infty) (locally 0).
Proof using a_pos b_pos D_pos K_pos M_pos.
  assert (I : filterlim Rinv (Rbar_locally m_infty) (locally 0))
    by (apply (is_lim_inv (fun x => x) m_infty m_infty (is_lim_id m_infty)); discriminate).
  pose proof w_pos as W; split.
  - set (h := fun y => (b / a * y ^ 2 - (1 + y) ^ 2) * ((2 * y + y ^ 2) * (b / a) - (1 + y) ^ 2) / (4 * (1 + y) ^ 4)).
    apply filterlim_ext_loc with (f := fun r => 2 * sqrt (h (/ r))).
    + exists (- 1 - w); intros r L; assert (A : on_arc r) by (right; right; exact L).
      unfold left_20; rewrite root_of_product by assumption; destruct (groups_pos r A) as (N0 & N1 & _).
      rewrite product_at by assumption.
      replace (h (/ r)) with ((b / a - (r + 1) ^ 2) * ((2 * r + 1) * (b / a) - (r + 1) ^ 2) / (4 * (r + 1) ^ 4))
        by (unfold h; field; repeat split; lra).
      field; lra.
    + apply (filterlim_comp _ _ _ Rinv (fun y => 2 * sqrt (h y)) _ (locally 0)); [exact I|].
      replace 1 with (2 * sqrt (h 0)).
      * change (continuous (fun y => 2 * sqrt (h y)) 0).
        apply (continuous_mult (fun _ => 2) (fun y => sqrt (h y))); [apply continuous_const|].
        apply (continuous_comp h sqrt); [|apply continuous_sqrt].
        apply (ex_derive_continuous h); unfold h; auto_derive; lra.
      * replace (h 0) with (/ 2 * / 2) by (unfold h; field; lra); rewrite sqrt_square by lra; field.
  - set (h := fun y => 2 * K * D / a * (y * (1 + y) ^ 2 / ((2 * y + y ^ 2) * (b / a) - (1 + y) ^ 2))).
    apply filterlim_ext_loc with (f := fun r => h (/ r)).
    + exists (- 1 - w); intros r L; assert (A : on_arc r) by (right; right; exact L).
      destruct (groups_pos r A) as (N0 & N1 & _ & Q); unfold h, sigma_at.
      assert (N : (2 * r + 1) * (b / a) - (r + 1) ^ 2 <> 0).
      { intros Z; unfold kappa_at in Q; rewrite Z, Rmult_0_r in Q; unfold Rdiv in Q; rewrite Rmult_0_l in Q; lra. }
      unfold kappa_at; set (B := b / a) in *; field; repeat split; try lra; intros Z; apply N; lra.
    + apply (filterlim_comp _ _ _ Rinv h _ (locally 0)); [exact I|].
      replace 0 with (h 0) at 2 by (unfold h; field; lra).
      change (continuous h 0); apply (ex_derive_continuous h); unfold h; auto_derive; lra.
Qed.

(** Claim B10 for a < b: two arcs, each with two ends. *)
Theorem B10 : a < b ->
  (forall V sigma, boundary V sigma <->
     exists r, (0 < r < w - 1 \/ r < - 1 - w) /\ V = V_at r /\ sigma = sigma_at r) /\
  (filterlim V_at (at_left (w - 1)) (locally 0) /\ filterlim sigma_at (at_left (w - 1)) (locally right_15)) /\
  (filterlim (fun r => left_18 (V_at r) (sigma_at r)) (at_right 0) (locally 1) /\
   filterlim (fun r => / sigma_at r) (at_right 0) (locally 0)) /\
  (filterlim V_at (at_left (- 1 - w)) (locally 0) /\ filterlim sigma_at (at_left (- 1 - w)) (locally right_16)) /\
  (filterlim (fun r => left_20 (V_at r) (sigma_at r)) (Rbar_locally m_infty) (locally 1) /\
   filterlim sigma_at (Rbar_locally m_infty) (locally 0)).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros L; assert (W1 : 1 < w).
  { unfold w; rewrite <- sqrt_1; apply sqrt_lt_1; [lra | left; pos |].
    apply (Rmult_lt_reg_r a); [exact a_pos|]; replace (b / a * a) with b by (field; lra); lra. }
  split; [|split; [|split; [|split; [|exact end_20]]]].
  - intros V sigma; rewrite boundary_is_curve; split; intros (r & A & E); exists r; (split; [|exact E]).
    + destruct A as [A|[A|A]]; [now left | lra | now right].
    + destruct A as [A|A]; [now left | now right; right].
  - destruct (end_15 ltac:(lra)) as [H1 H2]; split; (eapply filterlim_filter_le_1; [apply filter_le_within|]); assumption.
  - destruct (end_18 ltac:(lra)) as [H1 H2].
    assert (F : filter_le (at_right 0) (within on_arc (locally 0))).
    { intros Q [e H]; assert (P : 0 < Rmin e (w - 1)) by (apply Rmin_pos; [apply cond_pos | lra]).
      exists (mkposreal _ P); intros r B R; unfold ball in B; simpl in B; unfold AbsRing_ball, abs, minus, plus, opp in B; simpl in B.
      rewrite Ropp_0, Rplus_0_r, Rabs_pos_eq in B by lra.
      pose proof (Rmin_l e (w - 1)); pose proof (Rmin_r e (w - 1)).
      apply H; [|left; lra].
      unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl; rewrite Ropp_0, Rplus_0_r, Rabs_pos_eq; lra. }
    split; (eapply filterlim_filter_le_1; [exact F|]); assumption.
  - destruct end_16 as [H1 H2]; split; (eapply filterlim_filter_le_1; [apply filter_le_within|]); assumption.
Qed.

(** ** In which zone the boundary tends to eqs 18 and 20 *)

Let stable_at (V sigma : R) := stable (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma).
Let unstable_at (V sigma : R) := unstable (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma).

(** The zone is that of the sign of r. *)
Let zone (r : R) : on_arc r ->
  (0 < r -> unstable_at (V_at r) (sigma_at r)) /\ (r < 0 -> stable_at (V_at r) (sigma_at r)).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros A; destruct (double_at r A) as (v & s & Z & S); set (V := V_at r) in *; set (sigma := sigma_at r) in *.
  assert (F : 0 < V / D) by pos; split; intros L.
  - exists (RtoC (V / D * r)); split; [apply (complex_roots _ _ _ _ _ _ Z); now left | simpl; now apply Rmult_lt_0_compat].
  - apply double_stable with (V / D * r); try assumption; [unfold c3; pos | unfold c0; pos|].
    assert (0 < V / D * - r) by (apply Rmult_lt_0_compat; lra); lra.
Qed.

Let kappa_form (r : R) : r <> - 1 -> 2 * (r + 1) ^ 2 * kappa_at (b / a) r = r * ((2 * r + 1) * w ^ 2 - (r + 1) ^ 2).
Proof using a_pos b_pos. intros N; rewrite w_squared; unfold kappa_at; field; split; lra. Qed.

(** On the arc r < −1 − w, κ lies between 1/2 and r². *)
Let kappa_lower (r : R) : r < - 1 - w -> / 2 < kappa_at (b / a) r < r ^ 2.
Proof using a_pos b_pos.
  intros L; pose proof w_pos as W; pose proof (kappa_form r ltac:(lra)) as F.
  set (k := kappa_at (b / a) r) in *; set (m := (r + 1) ^ 2) in *.
  assert (M0 : w ^ 2 < m) by (unfold m; nra).
  assert (W2 : 0 < w ^ 2) by now apply pow_lt.
  assert (T : 0 < - r * (- (2 * r + 1))) by (apply Rmult_lt_0_compat; lra).
  assert (E : r * ((2 * r + 1) * w ^ 2 - m) = - r * (- (2 * r + 1)) * w ^ 2 + - r * m) by ring.
  split; apply (Rmult_lt_reg_l (2 * m)); try lra; rewrite F, E.
  - assert (0 < - r * (- (2 * r + 1)) * w ^ 2) by now apply Rmult_lt_0_compat.
    assert (0 < (- r - 1) * m) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 < - r * (- (2 * r + 1)) * (m - w ^ 2)) by (apply Rmult_lt_0_compat; lra).
    assert (2 * m * r ^ 2 = - r * (- (2 * r + 1)) * m + - r * m) by ring. lra.
Qed.

(** On the arc 0 < r < w − 1, κ is at least r times a constant, and bounded. *)
Let kappa_upper (r : R) : 0 < r < w - 1 ->
  Rmin (w ^ 2 - 1) (2 * (w - 1) * w ^ 2) * r <= 2 * w ^ 2 * kappa_at (b / a) r /\ kappa_at (b / a) r <= w ^ 4.
Proof using a_pos b_pos.
  intros L; pose proof (kappa_form r ltac:(lra)) as F.
  set (k := kappa_at (b / a) r) in *; set (c := Rmin _ _).
  assert (K0 : 0 < k) by (apply groups_pos; left; exact L).
  assert (M1 : 1 <= (r + 1) ^ 2 <= w ^ 2) by nra.
  set (m := (r + 1) ^ 2) in *; split.
  - assert (C : c <= (2 * r + 1) * w ^ 2 - m).
    { pose proof (Rmin_l (w ^ 2 - 1) (2 * (w - 1) * w ^ 2)) as C1; pose proof (Rmin_r (w ^ 2 - 1) (2 * (w - 1) * w ^ 2)) as C2; fold c in C1, C2.
      assert (E : (w - 1) * ((2 * r + 1) * w ^ 2 - m) =
                  (w - 1 - r) * (w ^ 2 - 1) + r * (2 * (w - 1) * w ^ 2) + (w - 1) * (r * (w - 1 - r))) by (unfold m; ring).
      assert ((w - 1 - r) * c <= (w - 1 - r) * (w ^ 2 - 1)) by (apply Rmult_le_compat_l; lra).
      assert (r * c <= r * (2 * (w - 1) * w ^ 2)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= (w - 1) * (r * (w - 1 - r))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
      apply (Rmult_le_reg_l (w - 1)); [lra|]; lra. }
    assert (2 * m * k <= 2 * w ^ 2 * k) by (apply Rmult_le_compat_r; lra).
    assert (r * c <= r * ((2 * r + 1) * w ^ 2 - m)) by (apply Rmult_le_compat_l; lra). lra.
  - assert (2 * 1 * k <= 2 * m * k) by (apply Rmult_le_compat_r; lra).
    assert (W2 : 0 < w ^ 2) by (apply pow_lt; lra).
    assert (T : r * (2 * r + 1) <= 2 * w ^ 2) by nra.
    apply (Rmult_le_compat_r (w ^ 2)) in T; [|lra].
    assert (0 <= r * m) by (apply Rmult_le_pos; lra).
    replace (w ^ 4) with (w ^ 2 * w ^ 2) by ring; lra.
Qed.

(** The same on the arc w − 1 < r < 0. *)
Let kappa_middle (r : R) : w - 1 < r < 0 ->
  w ^ 2 * (1 - w ^ 2) * - r <= 2 * kappa_at (b / a) r /\ kappa_at (b / a) r <= 1.
Proof using a_pos b_pos.
  intros L; pose proof w_pos as W; pose proof (kappa_form r ltac:(lra)) as F.
  assert (K0 : 0 < kappa_at (b / a) r) by (apply groups_pos; right; left; exact L).
  set (k := kappa_at (b / a) r) in *; set (m := (r + 1) ^ 2) in *.
  assert (M0 : w ^ 2 < m) by (unfold m; nra); assert (M1 : m < 1) by (unfold m; nra).
  assert (W2 : 0 < w ^ 2) by now apply pow_lt.
  split.
  - assert (C : w ^ 2 * (1 - w ^ 2) <= m - (2 * r + 1) * w ^ 2).
    { unfold m; replace ((r + 1) ^ 2 - (2 * r + 1) * w ^ 2) with ((r + 1 - w ^ 2) ^ 2 + w ^ 2 * (1 - w ^ 2)) by ring.
      pose proof (pow2_ge_0 (r + 1 - w ^ 2)); lra. }
    assert (- r * (w ^ 2 * (1 - w ^ 2)) <= - r * (m - (2 * r + 1) * w ^ 2)) by (apply Rmult_le_compat_l; lra).
    assert (2 * m * k <= 2 * 1 * k) by (apply Rmult_le_compat_r; lra). lra.
  - apply (Rmult_le_reg_l (2 * m)); [lra|]; rewrite F.
    assert (0 <= (r + 1) * (- r) * w ^ 2) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra]).
    assert (0 <= (r + 1) * (m - w ^ 2 * - r)) by (apply Rmult_le_pos; [lra|]; nra).
    assert (r * ((2 * r + 1) * w ^ 2 - m) = - r * m + r * (r + 1) * w ^ 2 + r * r * w ^ 2) by ring.
    assert (r * r * w ^ 2 <= m). { assert (r * r * w ^ 2 <= 1 * w ^ 2) by (apply Rmult_le_compat_r; nra). lra. }
    nra.
Qed.

(** Where κ is small, so is r; where κ is large, r is on the lower arc and far out. *)
Let small_kappa : a <> b -> exists c, 0 < c /\ forall r, on_arc r -> kappa_at (b / a) r < / 2 -> c * Rabs r <= kappa_at (b / a) r.
Proof using a_pos b_pos.
  intros N; pose proof w_pos as W.
  assert (W1 : w <> 1).
  { intros E; apply N; pose proof w_squared as S; rewrite E in S; apply (Rmult_eq_reg_r (/ a)); [|apply Rinv_neq_0_compat; lra].
    unfold Rdiv in S; rewrite <- S; field; lra. }
  assert (W2 : 0 < w ^ 2) by now apply pow_lt.
  destruct (Rlt_le_dec 1 w) as [L|L].
  - set (c := Rmin (w ^ 2 - 1) (2 * (w - 1) * w ^ 2)).
    assert (C : 0 < c) by (unfold c; apply Rmin_pos; [nra | apply Rmult_lt_0_compat; lra]).
    exists (c / (2 * w ^ 2)); split; [apply Rdiv_lt_0_compat; lra|]; intros r [A|[A|A]] S.
    + rewrite Rabs_pos_eq by lra; destruct (kappa_upper r A) as [H _]; fold c in H.
      apply (Rmult_le_reg_l (2 * w ^ 2)); [lra|]; replace (2 * w ^ 2 * (c / (2 * w ^ 2) * r)) with (c * r) by (field; lra); exact H.
    + lra.
    + pose proof (kappa_lower r A); lra.
  - assert (C : 0 < w ^ 2 * (1 - w ^ 2)) by (apply Rmult_lt_0_compat; [lra | nra]).
    exists (w ^ 2 * (1 - w ^ 2) / 2); split; [lra|]; intros r [A|[A|A]] S.
    + lra.
    + rewrite Rabs_left by lra; destruct (kappa_middle r A) as [H _]; lra.
    + pose proof (kappa_lower r A); lra.
Qed.

Let large_kappa : exists c, 1 <= c /\ forall r, on_arc r -> c < kappa_at (b / a) r -> r < - 1 - w /\ kappa_at (b / a) r < r ^ 2.
Proof using a_pos b_pos.
  exists (Rmax 1 (w ^ 4)); split; [apply Rmax_l|]; intros r A L.
  pose proof (Rmax_l 1 (w ^ 4)); pose proof (Rmax_r 1 (w ^ 4)); destruct A as [A|[A|A]].
  - destruct (kappa_upper r A); lra.
  - destruct (kappa_middle r A); lra.
  - split; [exact A | apply kappa_lower, A].
Qed.

Let kappa_of_sigma (r : R) : on_arc r -> kappa_at (b / a) r = K * D / (a * sigma_at r).
Proof using a_pos b_pos D_pos K_pos.
  intros A; destruct (groups_pos r A) as (_ & _ & _ & Q); unfold sigma_at; field; repeat split; apply Rgt_not_eq; assumption.
Qed.

(** For a <> b the boundary has points at arbitrarily large σ. There it tends to eq 18. For a < b it lies in the unstable zone there. *)
Theorem asymptote_18 : a <> b ->
  (forall s, exists V sigma, boundary V sigma /\ s < sigma) /\
  (forall e, 0 < e -> exists s, 0 < s /\ forall V sigma, boundary V sigma -> s < sigma ->
     Rabs (left_18 V sigma - 1) < e /\ (a < b -> unstable_at V sigma) /\ (b < a -> stable_at V sigma)).
Proof using a_pos b_pos D_pos K_pos M_pos.
  intros N; pose proof w_pos as W; destruct (end_18 N) as [H1 H2].
  assert (side : a < b /\ 1 < w \/ b < a /\ w < 1).
  { destruct (Rdichotomy _ _ N) as [L|L]; [left|right]; (split; [exact L|]);
      unfold w; rewrite <- sqrt_1 at 1; apply sqrt_lt_1; try lra; try (left; pos);
      apply (Rmult_lt_reg_r a); try exact a_pos; replace (b / a * a) with b by (field; lra); lra. }
  split.
  - intros s; set (s1 := Rmax 1 s); assert (S1 : 0 < s1) by (unfold s1; pose proof (Rmax_l 1 s); lra).
    assert (P : 0 < / s1) by now apply Rinv_0_lt_compat.
    destruct (proj1 (filterlim_locally _ _) H2 (mkposreal _ P)) as [d B].
    assert (X : exists r, on_arc r /\ Rabs r < d).
    { pose proof (cond_pos d) as D0; destruct side as [[_ L]|[_ L]].
      - exists (Rmin (d / 2) ((w - 1) / 2)); assert (0 < Rmin (d / 2) ((w - 1) / 2)) by (apply Rmin_pos; lra).
        pose proof (Rmin_l (d / 2) ((w - 1) / 2)); pose proof (Rmin_r (d / 2) ((w - 1) / 2)).
        split; [left; lra | rewrite Rabs_pos_eq by lra; lra].
      - exists (- Rmin (d / 2) ((1 - w) / 2)); assert (0 < Rmin (d / 2) ((1 - w) / 2)) by (apply Rmin_pos; lra).
        pose proof (Rmin_l (d / 2) ((1 - w) / 2)); pose proof (Rmin_r (d / 2) ((1 - w) / 2)).
        split; [right; left; lra | rewrite Rabs_Ropp, Rabs_pos_eq by lra; lra]. }
    destruct X as (r & A & R); exists (V_at r), (sigma_at r); split; [apply boundary_is_curve; now exists r|].
    destruct (double_at r A) as (_ & S0 & _).
    assert (Y : ball 0 (/ s1) (/ sigma_at r)).
    { apply B; [|exact A]; unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl; now rewrite Ropp_0, Rplus_0_r. }
    unfold ball in Y; simpl in Y; unfold AbsRing_ball, abs, minus, plus, opp in Y; simpl in Y; rewrite Ropp_0, Rplus_0_r in Y.
    rewrite Rabs_pos_eq in Y by (left; now apply Rinv_0_lt_compat).
    apply Rle_lt_trans with s1; [apply Rmax_r|].
    rewrite <- (Rinv_inv s1), <- (Rinv_inv (sigma_at r)); apply Rinv_lt_contravar; [|exact Y].
    apply Rmult_lt_0_compat; now apply Rinv_0_lt_compat.
  - intros e E; destruct (proj1 (filterlim_locally _ _) H1 (mkposreal _ E)) as [d B].
    destruct (small_kappa N) as (c & C & S); pose proof (cond_pos d) as D0.
    set (k := Rmin (/ 2) (c * d)); assert (K0 : 0 < k) by (unfold k; apply Rmin_pos; [lra | now apply Rmult_lt_0_compat]).
    exists (K * D / (a * k)); split; [pos|]; intros V sigma Y L; apply boundary_is_curve in Y; destruct Y as (r & A & -> & ->).
    destruct (double_at r A) as (_ & S0 & _); destruct (groups_pos r A) as (N0 & _ & _ & Q); pose proof (kappa_of_sigma r A) as F.
    assert (G : kappa_at (b / a) r < k).
    { rewrite F; apply (Rmult_lt_reg_r (a * sigma_at r)); [pos|].
      replace (K * D / (a * sigma_at r) * (a * sigma_at r)) with (K * D) by (field; lra).
      apply (Rmult_lt_compat_r (a * k)) in L; [|pos]; replace (K * D / (a * k) * (a * k)) with (K * D) in L by (field; lra); lra. }
    pose proof (Rmin_l (/ 2) (c * d)) as G1; pose proof (Rmin_r (/ 2) (c * d)) as G2; fold k in G1, G2.
    assert (R : Rabs r < d) by (apply (Rmult_lt_reg_l c); [exact C|]; pose proof (S r A ltac:(lra)); lra).
    split.
    + change (ball 1 e (left_18 (V_at r) (sigma_at r))); apply B; [|exact A].
      unfold ball; simpl; unfold AbsRing_ball, abs, minus, plus, opp; simpl; now rewrite Ropp_0, Rplus_0_r.
    + assert (Low : ~ r < - 1 - w) by (intros O; pose proof (kappa_lower r O); lra).
      destruct (zone r A) as [U T]; split; intros O; [apply U | apply T]; destruct A as [A|[A|A]]; lra.
Qed.

(** The boundary has points at arbitrarily small σ. There it tends to eq 20, and lies in the stable zone. *)
Theorem asymptote_20 :
  (forall s, 0 < s -> exists V sigma, boundary V sigma /\ sigma < s) /\
  (forall e, 0 < e -> exists s, 0 < s /\ forall V sigma, boundary V sigma -> sigma < s ->
     Rabs (left_20 V sigma - 1) < e /\ stable_at V sigma).
Proof using a_pos b_pos D_pos K_pos M_pos.
  pose proof w_pos as W; destruct end_20 as [H1 H2]; split.
  - intros s S; destruct (proj1 (filterlim_locally _ _) H2 (mkposreal _ S)) as [m B].
    set (r := Rmin m (- 1 - w) - 1); pose proof (Rmin_l m (- 1 - w)); pose proof (Rmin_r m (- 1 - w)).
    assert (A : on_arc r) by (right; right; unfold r; lra).
    exists (V_at r), (sigma_at r); split; [apply boundary_is_curve; now exists r|].
    destruct (double_at r A) as (_ & S0 & _); pose proof (B r ltac:(unfold r; lra)) as Y.
    unfold ball in Y; simpl in Y; unfold AbsRing_ball, abs, minus, plus, opp in Y; simpl in Y.
    rewrite Ropp_0, Rplus_0_r, Rabs_pos_eq in Y by lra; exact Y.
  - intros e E; destruct (proj1 (filterlim_locally _ _) H1 (mkposreal _ E)) as [m B].
    destruct large_kappa as (c & C & G).
    set (k := Rmax c (m ^ 2)); assert (K1 : 1 <= k) by (unfold k; pose proof (Rmax_l c (m ^ 2)); lra).
    exists (K * D / (a * k)); split; [pos|]; intros V sigma Y L; apply boundary_is_curve in Y; destruct Y as (r & A & -> & ->).
    destruct (double_at r A) as (_ & S0 & _); destruct (groups_pos r A) as (N0 & _ & _ & Q); pose proof (kappa_of_sigma r A) as F.
    assert (X : k < kappa_at (b / a) r).
    { rewrite F; apply (Rmult_lt_reg_r (a * sigma_at r)); [pos|].
      replace (K * D / (a * sigma_at r) * (a * sigma_at r)) with (K * D) by (field; lra).
      apply (Rmult_lt_compat_r (a * k)) in L; [|pos]; replace (K * D / (a * k) * (a * k)) with (K * D) in L by (field; lra); lra. }
    pose proof (Rmax_l c (m ^ 2)) as X1; pose proof (Rmax_r c (m ^ 2)) as X2; fold k in X1, X2.
    destruct (G r A ltac:(lra)) as [O P].
    split; [|apply (zone r A); lra].
    change (ball 1 e (left_20 (V_at r) (sigma_at r))); apply B.
    destruct (Rlt_le_dec r m) as [|T]; [assumption|]; exfalso; assert (m ^ 2 < r ^ 2) by lra; nra.
Qed.

End Plane.
