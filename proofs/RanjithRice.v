(** What inertia changes in Ranjith and Rice (1999), and the start of slip with the load point at rest: claims Q4, Q7 and Q8. *)

From Slipmode Require Export RiceRuina.

Section RanjithRice.

Variables A B L V V_r tau_0 : R.
Hypotheses (A_pos : 0 < A) (weakening : A < B) (L_pos : 0 < L) (V_pos : 0 < V) (V_r_pos : 0 < V_r).

(** Eqs 1, 2 and 4 to 10. *)
Let tau (v theta : R) := tau_0 + A * ln (v / V_r) + B * ln (theta * V_r / L).
Let aging (v theta : R) := 1 - v * theta / L.
Let theta_ss := L / V.
Let spring (K v : R) := K * (V - v).
Let at_rest (K v : R) := - K * v.
Let K_cr := (B - A) / L.
Let motion (M f tau : R) := (f - tau) / M.
Let tau_ss := tau_0 - (B - A) * ln (V / V_r).
Let K_c (M : R) := (B - A) / L * (1 + M * V ^ 2 / (A * L)).

(** P is the characteristic polynomial of steady sliding with mass. *)
Let with_mass (K M : R) (P : C -> C) :=
  characteristic3 (fun f v theta => spring K v) (fun f v theta => motion M f (tau v theta)) (fun f v theta => aging v theta)
    tau_ss V theta_ss P.

Let B_pos : 0 < B.
Proof using A_pos weakening. lra. Qed.

Let polynomial (K M : R) : 0 < K -> 0 < M -> exists P, with_mass K M P /\
  (all_decay P <-> K_c M < K) /\ (one_grows P <-> K < K_c M) /\ P 0%C = RtoC (K * V / (L * M)).
Proof using A_pos L_pos V_pos V_r_pos.
  intros k m; destruct (stability A B L V A_pos L_pos V_pos K M k m) as [H1 H2].
  pose proof (linearised A B L V V_r tau_0 A_pos L_pos V_pos V_r_pos aging K M (or_introl eq_refl) m) as H3.
  eexists; split; [exact H3|]; split; [exact H1|]; split; [exact H2|].
  unfold complex_cubic; project; field; lra.
Qed.

Let above (M : R) : 0 < M -> K_cr < K_c M.
Proof using A_pos weakening L_pos V_pos.
  intros m; unfold K_cr, K_c; assert (0 < (B - A) / L) by (assert (0 < B - A) by lra; pos).
  assert (0 < (B - A) / L * (M * V ^ 2 / (A * L))) by pos; lra.
Qed.

Let K_cr_pos : 0 < K_cr.
Proof using weakening L_pos. assert (0 < B - A) by lra; unfold K_cr; pos. Qed.

(** Claim Q8: with mass steady sliding is unstable exactly for K < K_c, which is larger than K_cr and tends to it as the mass tends to zero. *)
Theorem Q8 :
  (forall K M, 0 < K -> 0 < M -> exists P, with_mass K M P /\ (one_grows P <-> K < K_c M)) /\
  (forall M, 0 < M -> K_cr < K_c M) /\ filterlim K_c (at_right 0) (locally K_cr).
Proof using A_pos weakening L_pos V_pos V_r_pos polynomial above.
  split; [|split; [exact above|]].
  - intros K M k m; destruct (polynomial K M k m) as (P & H & _ & G & _); now exists P.
  - exact (R8 A B L V A_pos L_pos).
Qed.

(** Claim Q7 fails for every mass: at K_cr a disturbance grows, between K_cr and K_c steady sliding is not stable, and the
    characteristic polynomial is positive at zero, so that a root is real and negative at every K. *)
Theorem Q7 (M : R) : 0 < M ->
  (exists P, with_mass K_cr M P /\ one_grows P) /\
  (forall K, K_cr < K -> K < K_c M -> exists P, with_mass K M P /\ ~ all_decay P) /\
  (forall K, 0 < K -> exists P p, with_mass K M P /\ P 0%C = RtoC p /\ 0 < p).
Proof using A_pos weakening L_pos V_pos V_r_pos polynomial above K_cr_pos.
  intros m; pose proof K_cr_pos as KP; split; [|split].
  - destruct (polynomial K_cr M KP m) as (P & H & _ & G & _); exists P; split; [exact H|]; apply G; now apply above.
  - intros K H1 H2; destruct (polynomial K M ltac:(lra) m) as (P & H & S & _); exists P; split; [exact H|].
    intros D; apply S in D; lra.
  - intros K k; destruct (polynomial K M k m) as (P & H & _ & _ & Z); exists P, (K * V / (L * M)); split; [exact H|].
    split; [exact Z | pos].
Qed.

(** Claim Q4 in its first reading fails: without inertia and with the load point at rest some starts accelerate, for every K from K_cr up
    to B/L. The acceleration is the one with which friction (its slopes are [direct] and [by_state]) follows the spring. *)
Theorem Q4 (K : R) : K_cr <= K -> K < B / L ->
  exists v theta direct by_state, 0 < v /\ 0 < theta /\
    is_derive (fun v => tau v theta) v direct /\ is_derive (fun theta => tau v theta) theta by_state /\
    0 < (at_rest K v - by_state * aging v theta) / direct.
Proof using A_pos weakening L_pos V_r_pos K_cr_pos.
  intros H1 H2; pose proof K_cr_pos as KP.
  assert (G : 0 < B - K * L).
  { apply (Rmult_lt_compat_r L) in H2; [|exact L_pos]; replace (B / L * L) with B in H2 by (field; lra); lra. }
  set (v := 2 * B * L / (B - K * L)); assert (Pv : 0 < v) by (unfold v; pos).
  exists v, 1, (A / v), B; split; [exact Pv|]; split; [lra|]; split; [|split].
  - unfold tau; auto_derive; [repeat split; try exact I; pos|]; real; field; repeat split; lra.
  - unfold tau; auto_derive; [repeat split; try exact I; pos|]; real; field; repeat split; lra.
  - unfold at_rest, aging; replace ((- K * v - B * (1 - v * 1 / L)) / (A / v)) with (B * v / A)
      by (unfold v; field; repeat split; lra).
    pos.
Qed.

End RanjithRice.
