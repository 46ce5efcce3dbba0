(** What theorems on whole formulas of claims use: equations solved for a variable, monotone functions, steps as facts. *)

From Slipmode Require Export Branches.

(** l = r, divided by the slope in x, is x = v. *)
Lemma solved_for (l r s x v : R) : l = r -> x - v = (l - r) / s -> x = v.
Proof.
  intros -> E; replace ((r - r) / s) with 0 in E by (unfold Rdiv; ring); lra.
Qed.

Lemma same_difference (l r a b : R) : l = r -> a - b = l - r -> a = b.
Proof. lra. Qed.

Lemma rises (f g : R -> R) (x y : R) :
  (forall t, x <= t <= y -> is_derive f t (g t)) -> (forall t, x <= t <= y -> 0 < g t) -> x < y -> f x < f y.
Proof.
  intros D G L; destruct (MVT_gen f x y g) as (c & C & E); rewrite ?Rmin_left, ?Rmax_right in * by lra.
  - intros t T; apply D; lra.
  - intros t T; apply continuity_pt_filterlim, (ex_derive_continuous f); eexists; apply D; lra.
  - assert (0 < g c * (y - x)) by (apply Rmult_lt_0_compat; [now apply G | lra]); lra.
Qed.

Lemma falls (f g : R -> R) (x y : R) :
  (forall t, x <= t <= y -> is_derive f t (g t)) -> (forall t, x <= t <= y -> 0 < - g t) -> x < y -> f y < f x.
Proof.
  intros D G L; apply Ropp_lt_cancel.
  apply (rises (fun t => - f t) (fun t => - g t)); [|exact G | exact L].
  intros t T; apply (is_derive_opp f); now apply D.
Qed.

(** The assumptions of a step that follow from the context. *)
Ltac assumed h :=
  repeat lazymatch type of h with
    | ?A -> _ => let g := fresh in assert (g : A) by first [assumption | lra]; specialize (h g); clear g
    end.

(** The goal is what a step states, but for the order of its terms. *)
Ltac stated h :=
  assumed h;
  first
    [ exact h
    | lra
    | intros ?; lra
    | apply (same_difference _ _ _ _ h); ring ].

(** The slope of a function. *)
Ltac slope := auto_derive; [ repeat split; first [exact I | divisor | pos] | field; divisors ].

Lemma derivative_as (f : R -> R) (x d e : R) : d = e -> is_derive f x d -> is_derive f x e.
Proof. now intros ->. Qed.

(** The derivative of a function, which Coq differentiates by itself. *)
Ltac derivative :=
  auto_derive;
  [ repeat split; first [exact I | pos | divisor | nra]
  | lazymatch goal with |- ?u = ?v => change (u = v :> R) end; unfold Rdiv; field; divisors ].
