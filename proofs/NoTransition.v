(** The sign of eq 9 of Im and Avouac without velocity weakening, which claim S5 states besides the roots. *)

From Slipmode Require Export Tactics.

Section NoTransition.

Variables a b D M sigma V : R.
Hypotheses (a_pos : 0 < a) (D_pos : 0 < D) (M_pos : 0 < M) (sigma_pos : 0 < sigma).

(** Eq 9 of Im and Avouac. *)
Let critical := (b - a) * sigma / D * (1 + M * V ^ 2 / (sigma * a * D)).

Theorem S5_critical : (b < a -> critical < 0) /\ (b = a -> critical = 0).
Proof using a_pos D_pos M_pos sigma_pos.
  assert (0 <= V ^ 2) by apply pow2_ge_0.
  assert (0 <= M * V ^ 2 / (sigma * a * D)).
  { apply Rmult_le_pos; [nra|]; left; apply Rinv_0_lt_compat; repeat apply Rmult_lt_0_compat; assumption. }
  assert (0 < sigma / D) by now apply Rdiv_lt_0_compat.
  assert (E : critical = - ((a - b) * (sigma / D * (1 + M * V ^ 2 / (sigma * a * D)))))
    by (unfold critical; field; lra).
  rewrite E; split; [intros L | intros ->; ring].
  assert (0 < (a - b) * (sigma / D * (1 + M * V ^ 2 / (sigma * a * D)))); [|lra].
  apply Rmult_lt_0_compat; [lra|]; apply Rmult_lt_0_compat; lra.
Qed.

End NoTransition.
