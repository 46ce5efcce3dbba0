(** Eq 8 of Im and Avouac in its three dimensionless groups: η = M V²/(σ a D), κ = K D/(a σ) and β = b/a.

    With s = p V/D it is η p³ + (1 + η) p² + (κ + 1 − β) p + κ = 0. It always has the real root p = −1 − y with y > 0.
    The other two roots are −1 + q with q² − S q + P = 0. The numbers y, S and P stand for η and κ: one relation ties them,
    y (P − β) = β (2 − S). *)

From Slipmode Require Export Cubics.

(** What y, S and P say of η and κ. *)
Definition parts (eta kappa beta y S P : R) : Prop :=
  0 < y /\ y * (P - beta) = beta * (2 - S) /\ eta * (2 - S + y) = 1 /\ kappa = eta * (1 + y) * (P - S + 1).

Definition dimensionless (eta kappa beta : R) : C -> C := complex_cubic eta (1 + eta) (kappa + 1 - beta) kappa.

Theorem parts_exist (eta kappa beta : R) :
  0 < eta -> 0 < kappa -> 0 < beta -> exists y S P, parts eta kappa beta y S P.
Proof.
  intros E K B.
  destruct (root_below (cubic eta (1 + eta) (kappa + 1 - beta) kappa)
    [kappa; kappa + 1 - beta; 1 + eta; eta] [kappa; - (kappa + 1 - beta); 1 + eta; - eta] (- 1)) as (r & L & Z).
  { intros s; unfold cubic; simpl; ring. }
  { intros s; simpl; ring. }
  { left; split; [unfold cubic|simpl]; lra. }
  set (y := - 1 - r); assert (Y : 0 < y) by (unfold y; lra); assert (N : 0 < 1 + y) by lra.
  exists y, (2 + y - / eta), (kappa / (eta * (1 + y)) + 1 + y - / eta).
  assert (Z' : kappa * y + eta * y * (1 + y) ^ 2 - (1 + y) * (y + beta) = 0).
  { replace r with (- 1 - y) in Z by (unfold y; ring); unfold cubic in Z; lra. }
  split; [exact Y|]; split; [|split; field; lra].
  apply (Rmult_eq_reg_r (eta * (1 + y))); [|apply Rgt_not_eq, Rmult_lt_0_compat; lra].
  apply Rminus_diag_uniq; rewrite <- Z'; field; lra.
Qed.

Section Parts.

Variables eta kappa beta y S P : R.
Hypotheses (eta_pos : 0 < eta) (kappa_pos : 0 < kappa) (beta_pos : 0 < beta) (known : parts eta kappa beta y S P).

Lemma factors (z : C) :
  dimensionless eta kappa beta z = (RtoC eta * (z + RtoC (1 + y)) * quadratic 1 (2 - S) (P - S + 1) z)%C.
Proof using known.
  destruct known as (Y & R & E & K).
  assert (E2 : 1 + eta = eta * (2 - S + (1 + y))) by lra.
  assert (E1 : kappa + 1 - beta = eta * ((1 + y) * (2 - S) + (P - S + 1))).
  { apply Rminus_diag_uniq; rewrite K.
    transitivity (eta * (y * (P - beta) - beta * (2 - S)) + (1 - beta) * (1 - eta * (2 - S + y))); [ring|].
    rewrite R, E; ring. }
  unfold dimensionless; rewrite E2, E1, K; destruct z as [u v]; unfold complex_cubic, quadratic; project; ring.
Qed.

Lemma roots (z : C) :
  dimensionless eta kappa beta z = 0%C <-> z = RtoC (- (1 + y)) \/ quadratic 1 (2 - S) (P - S + 1) z = 0%C.
Proof using eta_pos known.
  rewrite factors; split.
  - intros H; apply integral in H; destruct H as [H|H]; [left|now right].
    apply integral in H; destruct H as [H|H]; [apply (f_equal fst) in H; simpl in H; lra|].
    replace z with (z + RtoC (1 + y) - RtoC (1 + y))%C by ring; rewrite H, RtoC_opp; ring.
  - intros [->|H]; [rewrite RtoC_opp|rewrite H]; ring.
Qed.

Lemma product_pos : 0 < P - S + 1.
Proof using eta_pos kappa_pos known.
  destruct known as (Y & _ & _ & K).
  assert (0 < eta * (1 + y)) by (apply Rmult_lt_0_compat; lra).
  destruct (Rlt_le_dec 0 (P - S + 1)) as [|L]; [assumption|]; exfalso; nra.
Qed.

(** The pair is real exactly for S² >= 4 P, and it grows exactly for S > 2. *)
Theorem real_by_parts : (forall z, dimensionless eta kappa beta z = 0%C -> snd z = 0) <-> 4 * P <= S ^ 2.
Proof using eta_pos known.
  split.
  - intros H; destruct (Rle_lt_dec (4 * P) (S ^ 2)) as [|L]; [assumption|]; exfalso.
    destruct (quadratic_root 1 (2 - S) (P - S + 1) ltac:(lra)) as (u & v & Z & _ & _ & I).
    assert (v = 0) by (apply (H (u, v)), roots; now right); subst v.
    apply quadratic_parts in Z; specialize (I ltac:(lra)); nra.
  - intros L [u v] Z; apply roots in Z; destruct Z as [Z|Z]; [exact (f_equal snd Z)|].
    apply quadratic_parts in Z; destruct Z as [Z1 Z2]; simpl.
    apply Rmult_integral in Z2; destruct Z2 as [|Z2]; [assumption|]; nra.
Qed.

Theorem growing_by_parts : (exists z, dimensionless eta kappa beta z = 0%C /\ 0 < fst z) <-> 2 < S.
Proof using eta_pos kappa_pos known.
  pose proof product_pos as PP; split.
  - intros ([u v] & Z & L); simpl in L; apply roots in Z; destruct Z as [Z|Z].
    { apply (f_equal fst) in Z; simpl in Z; destruct known as (Y & _); lra. }
    apply quadratic_parts in Z; destruct Z as [Z1 Z2]; apply Rmult_integral in Z2; destruct Z2 as [->|Z2]; nra.
  - intros L; destruct (quadratic_root 1 (2 - S) (P - S + 1) ltac:(lra)) as (u & v & Z & U & _).
    exists (u, v); split; [apply roots; now right | simpl; lra].
Qed.

Theorem stable_by_parts : (forall z, dimensionless eta kappa beta z = 0%C -> fst z < 0) <-> S < 2.
Proof using eta_pos kappa_pos known.
  pose proof product_pos as PP; pose proof (quadratic_stable 1 (2 - S) (P - S + 1) ltac:(lra)) as Q; split.
  - intros H; destruct (proj1 Q); [|lra].
    intros z Z; apply H, roots; now right.
  - intros L z Z; apply roots in Z; destruct Z as [->|Z].
    + simpl; destruct known as (Y & _); lra.
    + apply Q; [lra | exact Z].
Qed.

Theorem side_by_parts : (2 < S <-> P < beta) /\ (S < 2 <-> beta < P).
Proof using known beta_pos.
  destruct known as (Y & R & _); split; split; intros L.
  - destruct (Rlt_le_dec P beta) as [|M]; [assumption|]; nra.
  - destruct (Rlt_le_dec 2 S) as [|M]; [assumption|]; nra.
  - destruct (Rlt_le_dec beta P) as [|M]; [assumption|]; nra.
  - destruct (Rlt_le_dec S 2) as [|M]; [assumption|]; nra.
Qed.

End Parts.

(** Which y belongs to S and P off S = 2. *)
Lemma parts_of (beta S P : R) :
  0 < beta -> 0 < P - S + 1 -> (S < 2 /\ beta < P) \/ (2 < S /\ P < beta) ->
  let y := beta * (2 - S) / (P - beta) in
  let eta := / (2 - S + y) in
  let kappa := eta * (1 + y) * (P - S + 1) in
  0 < 2 - S + y /\ 0 < eta /\ 0 < kappa /\ parts eta kappa beta y S P.
Proof.
  intros B Q H; cbv zeta; set (y := beta * (2 - S) / (P - beta)).
  assert (N : P - beta <> 0) by lra.
  assert (Y : 0 < y).
  { unfold y; destruct H as [[H1 H2]|[H1 H2]]; [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | lra]|].
    replace (beta * (2 - S) / (P - beta)) with (beta * (S - 2) / (beta - P)) by (field; lra).
    apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | lra]. }
  assert (R : y * (P - beta) = beta * (2 - S)) by (unfold y; field; exact N).
  assert (W : 0 < 2 - S + y).
  { destruct H as [[H1 H2]|[H1 H2]]; [lra|].
    destruct (Rlt_le_dec 0 (2 - S + y)) as [|L]; [assumption|]; exfalso; nra. }
  assert (E : 0 < / (2 - S + y)) by now apply Rinv_0_lt_compat.
  split; [exact W|]; split; [exact E|]; split.
  - apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | exact Q].
  - split; [exact Y|]; split; [exact R|]; split; [field; lra | reflexivity].
Qed.

(** ** The groups of eq 8 *)

Section Groups.

Variables a b D K M V sigma : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M) (V_pos : 0 < V) (sigma_pos : 0 < sigma).

(** The coefficients of eq 8. *)
Let c3 := M / sigma.
Let c2 := a / V + M * V / (sigma * D).
Let c1 := K / sigma + (a - b) / D.
Let c0 := K * V / (sigma * D).

(** The inertial parameter of the text. *)
Let eta := M * V ^ 2 / (sigma * a * D).
Let kappa := K * D / (a * sigma).

Theorem groups (p : C) :
  complex_cubic c3 c2 c1 c0 (RtoC (V / D) * p)%C = 0%C <-> dimensionless eta kappa (b / a) p = 0%C.
Proof using a_pos b_pos D_pos K_pos M_pos V_pos sigma_pos.
  unfold dimensionless; rewrite <- (scaled_root (a * V / D ^ 2) (V / D) eta (1 + eta) (kappa + 1 - b / a) kappa p); try (apply Rgt_not_eq; red; pos).
  replace (a * V / D ^ 2 * eta / (V / D) ^ 3) with c3 by (unfold c3, eta; field; repeat split; apply Rgt_not_eq; assumption).
  replace (a * V / D ^ 2 * (1 + eta) / (V / D) ^ 2) with c2
    by (unfold c2, eta; field; repeat split; apply Rgt_not_eq; assumption).
  replace (a * V / D ^ 2 * (kappa + 1 - b / a) / (V / D)) with c1
    by (unfold c1, kappa; field; repeat split; apply Rgt_not_eq; assumption).
  replace (a * V / D ^ 2 * kappa) with c0 by (unfold c0, kappa; field; repeat split; apply Rgt_not_eq; assumption).
  reflexivity.
Qed.

Lemma groups_parts (p : C) : (fst (RtoC (V / D) * p)%C = V / D * fst p /\ snd (RtoC (V / D) * p)%C = V / D * snd p)%R.
Proof using. destruct p as [x y]; simpl; split; ring. Qed.

(** Each root of eq 8 comes from one of the dimensionless cubic. *)
Lemma groups_onto (z : C) : exists p, z = (RtoC (V / D) * p)%C.
Proof using V_pos D_pos.
  exists (RtoC (D / V) * z)%C; destruct z as [x y]; project; field; split; apply Rgt_not_eq; assumption.
Qed.

Let factor_pos : 0 < V / D.
Proof using V_pos D_pos. pos. Qed.

Theorem real_groups : real_roots c3 c2 c1 c0 <-> (forall p, dimensionless eta kappa (b / a) p = 0%C -> snd p = 0).
Proof using a_pos b_pos D_pos K_pos M_pos V_pos sigma_pos.
  pose proof factor_pos as F; split.
  - intros H p Z; apply groups, H in Z; rewrite (proj2 (groups_parts p)) in Z; apply Rmult_integral in Z; lra.
  - intros H z Z; destruct (groups_onto z) as [p ->]; apply groups, H in Z; rewrite (proj2 (groups_parts p)), Z; ring.
Qed.

Theorem stable_groups : stable c3 c2 c1 c0 <-> (forall p, dimensionless eta kappa (b / a) p = 0%C -> fst p < 0).
Proof using a_pos b_pos D_pos K_pos M_pos V_pos sigma_pos.
  pose proof factor_pos as F; split.
  - intros H p Z; apply groups, H in Z; rewrite (proj1 (groups_parts p)) in Z; nra.
  - intros H z Z; destruct (groups_onto z) as [p ->]; apply groups, H in Z; rewrite (proj1 (groups_parts p)); nra.
Qed.

Theorem unstable_groups : unstable c3 c2 c1 c0 <-> (exists p, dimensionless eta kappa (b / a) p = 0%C /\ 0 < fst p).
Proof using a_pos b_pos D_pos K_pos M_pos V_pos sigma_pos.
  pose proof factor_pos as F; split.
  - intros (z & Z & P); destruct (groups_onto z) as [p ->]; exists p; apply groups in Z; split; [exact Z|].
    rewrite (proj1 (groups_parts p)) in P; nra.
  - intros (p & Z & P); exists (RtoC (V / D) * p)%C; split; [now apply groups|].
    rewrite (proj1 (groups_parts p)); nra.
Qed.

End Groups.
