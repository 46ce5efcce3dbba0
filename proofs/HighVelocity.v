(** Eq 8 for high velocities and for low normal stresses: eqs 21 and 22, claim Q2 of Im and Avouac. *)

From Slipmode Require Export Asymptotes.

Section HighVelocity.

Variables a b D K M : R.
Hypotheses (a_pos : 0 < a) (b_pos : 0 < b) (D_pos : 0 < D) (K_pos : 0 < K) (M_pos : 0 < M).

(** The coefficients of eq 8, with the velocity and the normal stress that change, and those of eqs 21 and 22. *)
Let c3 (V sigma : R) := M / sigma.
Let c2 (V sigma : R) := a / V + M * V / (sigma * D).
Let c1 (V sigma : R) := K / sigma + (a - b) / D.
Let c0 (V sigma : R) := K * V / (sigma * D).
Let m2 := M.
Let m0 := K.
Let n3 := M.
Let n2 (V : R) := M * V / D.
Let n1 := K.
Let n0 (V : R) := K * V / D.
Let omega_n := sqrt (K / M).

(** Claim Q2, besides the limits of the roots: eq 8 tends to eq 21 for high velocities and to eq 22 for low normal stresses. The roots of
    eq 21 are ±iω_n, and those of eq 22 are these and −V_0/D_c. *)
Theorem Q2 :
  (forall sigma z, 0 < sigma ->
     tends (fun V => RtoC (sigma * D / V) * complex_cubic (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma) z)%C
       (Rbar_locally p_infty) (quadratic m2 0 m0 z)) /\
  (forall V z, 0 < V ->
     tends (fun sigma => RtoC sigma * complex_cubic (c3 V sigma) (c2 V sigma) (c1 V sigma) (c0 V sigma) z)%C
       (at_right 0) (complex_cubic n3 (n2 V) n1 (n0 V) z)) /\
  (forall z, quadratic m2 0 m0 z = 0%C <-> z = (Ci * RtoC omega_n)%C \/ z = (- (Ci * RtoC omega_n))%C) /\
  (forall V z, 0 < V -> (complex_cubic n3 (n2 V) n1 (n0 V) z = 0%C <->
     z = (Ci * RtoC omega_n)%C \/ z = (- (Ci * RtoC omega_n))%C \/ z = RtoC (- (V / D)))).
Proof using D_pos K_pos M_pos.
  assert (W : omega_n ^ 2 = K / M) by (unfold omega_n; apply root_squared; left; pos).
  assert (Q : forall z, quadratic m2 0 m0 z = (RtoC M * (z - Ci * RtoC omega_n) * (z + Ci * RtoC omega_n))%C).
  { intros [x y]; unfold quadratic, m2, m0; replace K with (M * omega_n ^ 2) by (rewrite W; field; lra); project; ring. }
  assert (N : RtoC M <> 0%C) by (intros H; apply (f_equal fst) in H; simpl in H; lra).
  assert (E : forall z u : C, (z - u = 0)%C -> z = u) by (intros z u H; replace z with (z - u + u)%C by ring; rewrite H; ring).
  assert (Z : forall z, quadratic m2 0 m0 z = 0%C <-> z = (Ci * RtoC omega_n)%C \/ z = (- (Ci * RtoC omega_n))%C).
  { intros z; rewrite Q; split.
    - intros H; apply integral in H; destruct H as [H|H]; [apply integral in H; destruct H as [H|H]|]; [contradiction | left | right].
      + now apply E.
      + apply E; rewrite <- H; ring.
    - intros [->| ->]; ring. }
  split; [|split; [|split; [exact Z|]]].
  - intros sigma z S; apply inverse_tends with
      (v := (RtoC (M * D) * z * z * z + RtoC (K * D + (a - b) * sigma) * z)%C) (w := (RtoC (a * sigma * D) * z * z)%C).
    intros V P; unfold c3, c2, c1, c0, m2, m0, complex_cubic, quadratic; destruct z as [x y]; project; field;
      repeat split; apply Rgt_not_eq; assumption.
  - intros V z P; apply affine_tends with (v := (RtoC (a / V) * z * z + RtoC ((a - b) / D) * z)%C).
    intros sigma S; unfold c3, c2, c1, c0, n3, n2, n1, n0, complex_cubic; destruct z as [x y]; project; field;
      repeat split; apply Rgt_not_eq; assumption.
  - intros V z P.
    assert (F : complex_cubic n3 (n2 V) n1 (n0 V) z = (quadratic m2 0 m0 z * (z - RtoC (- (V / D))))%C).
    { unfold complex_cubic, quadratic, n3, n2, n1, n0, m2, m0; destruct z as [x y]; project; field; lra. }
    rewrite F; split.
    + intros H; apply integral in H; destruct H as [H|H]; [apply Z in H; tauto | right; right; now apply E].
    + intros H; assert (X : quadratic m2 0 m0 z = 0%C \/ z = RtoC (- (V / D))) by (rewrite Z; tauto).
      destruct X as [-> | ->]; ring.
Qed.

End HighVelocity.
