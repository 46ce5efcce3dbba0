(** What theorems on formulas with or, not, implies and iff use, and on formulas about roots: the formula over the signs of its
    expressions, and steps as facts on these signs. *)

From Slipmode Require Export Claims HalfPlane.
From Interval Require Import Tactic.
From Interval.Float Require Import Specific_ops Specific_stdz.

(** Numbers of Coq's integers: with the machine's numbers, which the library takes by default, their axioms would be assumed. *)
Module Numbers := SpecificFloat StdZRadix2.
Module OnIntegers := IntervalTactic Numbers.
Import OnIntegers.

(** ** A formula is one over signs *)

Lemma from_signs (A B : Prop) : (A <-> B) -> B -> A.
Proof. tauto. Qed.

Lemma both_and (A B C D : Prop) : (A <-> C) -> (B <-> D) -> (A /\ B <-> C /\ D).
Proof. tauto. Qed.

Lemma both_or (A B C D : Prop) : (A <-> C) -> (B <-> D) -> (A \/ B <-> C \/ D).
Proof. tauto. Qed.

Lemma both_imply (A B C D : Prop) : (A <-> C) -> (B <-> D) -> ((A -> B) <-> (C -> D)).
Proof. tauto. Qed.

Lemma both_iff (A B C D : Prop) : (A <-> C) -> (B <-> D) -> ((A <-> B) <-> (C <-> D)).
Proof. tauto. Qed.

Lemma both_not (A C : Prop) : (A <-> C) -> (~ A <-> ~ C).
Proof. tauto. Qed.

Lemma same_positive (x y : R) : x = y -> (0 < x <-> 0 < y).
Proof. now intros ->. Qed.

Lemma same_not_negative (x y : R) : x = y -> (0 <= x <-> 0 <= y).
Proof. now intros ->. Qed.

Lemma same_negative (x y : R) : x = y -> (x < 0 <-> y < 0).
Proof. now intros ->. Qed.

Lemma opposite_positive (x y : R) : - x = y -> (x < 0 <-> 0 < y).
Proof. intros E; split; lra. Qed.

Lemma same_zero (x y : R) : x = y -> (x = 0 <-> y = 0).
Proof. now intros ->. Qed.

Lemma less_positive (l r y : R) : r - l = y -> (l < r <-> 0 < y).
Proof. intros E; split; lra. Qed.

Lemma at_most_not_negative (l r y : R) : r - l = y -> (l <= r <-> 0 <= y).
Proof. intros E; split; lra. Qed.

Lemma equal_zero (l r y : R) : l - r = y -> (l = r <-> y = 0).
Proof. intros E; split; lra. Qed.

Lemma unequal_signs (l r y : R) : l - r = y -> (l <> r <-> y < 0 \/ 0 < y).
Proof. intros E; split; [intros N; destruct (Rtotal_order y 0) as [|[|]]; [tauto | exfalso; apply N; lra | tauto] | lra]. Qed.

Ltac same_value := first [reflexivity | ring | field; divisors | lra].

Ltac by_signs :=
  lazymatch goal with
  | |- (_ <-> _) <-> (_ <-> _) => apply both_iff; by_signs
  | |- all_left [_] <-> _ => eapply iff_trans; [apply left_form_0 | by_signs]
  | |- all_left [_; _] <-> _ => eapply iff_trans; [apply left_form_1 | by_signs]
  | |- all_left [_; _; _] <-> _ => eapply iff_trans; [apply left_form_2 | by_signs]
  | |- all_left [_; _; _; _] <-> _ => eapply iff_trans; [apply left_form_3 | by_signs]
  | |- all_left [_; _; _; _; _] <-> _ => eapply iff_trans; [apply left_form_4 | by_signs]
  | |- one_right [_] <-> _ => eapply iff_trans; [apply right_form_0 | by_signs]
  | |- one_right [_; _] <-> _ => eapply iff_trans; [apply right_form_1 | by_signs]
  | |- one_right [_; _; _] <-> _ => eapply iff_trans; [apply right_form_2 | by_signs]
  | |- one_right [_; _; _; _] <-> _ => eapply iff_trans; [apply right_form_3 | by_signs]
  | |- one_right [_; _; _; _; _] <-> _ => eapply iff_trans; [apply right_form_4 | by_signs]
  | |- all_real [_] <-> _ => eapply iff_trans; [apply real_form_0 | by_signs]
  | |- all_real [_; _] <-> _ => eapply iff_trans; [apply real_form_1 | by_signs]
  | |- all_real [_; _; _] <-> _ => eapply iff_trans; [apply real_form_2 | by_signs]
  | |- all_real [_; _; _; _] <-> _ => eapply iff_trans; [apply real_form_3 | by_signs]
  | |- (_ <> _) <-> _ => first [apply unequal_signs; same_value | apply both_not; by_signs]
  | |- (~ _) <-> (~ _) => apply both_not; by_signs
  | |- (_ /\ _) <-> (_ /\ _) => apply both_and; by_signs
  | |- (_ \/ _) <-> (_ \/ _) => apply both_or; by_signs
  | |- (_ = _) <-> (_ = _) => first [apply same_zero; same_value | apply equal_zero; same_value]
  | |- (0 <= _) <-> (0 <= _) => first [apply same_not_negative; same_value | apply at_most_not_negative; same_value]
  | |- (0 < _) <-> (0 < _) => first [apply same_positive; same_value | apply less_positive; same_value]
  | |- (_ < 0) <-> (_ < 0) => apply same_negative; same_value
  | |- (_ < 0) <-> (0 < _) => first [apply opposite_positive; same_value | apply less_positive; same_value]
  | |- (_ < _) <-> (0 < _) => apply less_positive; same_value
  | |- (_ <= _) <-> (0 <= _) => apply at_most_not_negative; same_value
  | |- (_ -> _) <-> (_ -> _) => apply both_imply; by_signs
  | |- _ => tauto
  end.

(** ** Facts on signs *)

Lemma square_not_negative (e : R) : sqrt e ^ 2 = e -> 0 <= e.
Proof. intros <-; apply pow2_ge_0. Qed.

Lemma inverse_nonzero (e f : R) : e * f = 1 -> e < 0 \/ 0 < e.
Proof. intros E; destruct (Rtotal_order e 0) as [|[->|]]; [tauto | lra | tauto]. Qed.

Lemma inverse_of_opposite (e f : R) : - (e * f) = 1 -> e < 0 \/ 0 < e.
Proof. intros E; apply (inverse_nonzero e (- f)); lra. Qed.

(** What a step says of a sign. *)
Ltac sign_of h :=
  lazymatch type of h with
  | sqrt ?e ^ 2 = ?e => apply square_not_negative in h
  | ?e * _ = 1 => apply inverse_nonzero in h
  | - (?e * ?f) = 1 => apply (inverse_of_opposite e f) in h
  | _ => idtac
  end.

Lemma zero_quotient (e s : R) : e = 0 -> e / s = 0.
Proof. intros ->; unfold Rdiv; ring. Qed.

(** The cases by the sign of an expression. Where it is zero a variable has a value: a step has solved it. *)
Ltac case_of_zero f x v :=
  assumed f;
  let zero := fresh in
  let cases e := destruct (Rtotal_order e 0) as [|[zero|]]; [ | assert (value : x = v) | ] in
  lazymatch type of f with
  | ?e / ?s = _ => cases e; [ | rewrite (zero_quotient e s zero) in f; lra | subst x | ]
  | - (?e / ?s) = _ => cases e; [ | rewrite (zero_quotient e s zero) in f; lra | subst x | ]
  | ?e = _ => cases e; [ | lra | subst x | ]
  end.

(** An expression in the goal becomes a variable. *)
Ltac named e :=
  lazymatch e with
  | - ?inner => named inner
  | IZR _ => fail
  | _ => tryif is_var e then fail else (let x := fresh in set (x := e) in *; clearbody x)
  end.

Ltac names :=
  repeat match goal with
    | |- context [0 < ?e] => named e
    | |- context [0 <= ?e] => named e
    | |- context [?e = 0] => named e
    | |- context [?e < 0] => named e
    end.

(** The cases by the sign of an expression that a step has solved. *)
Ltac zero_case h e s :=
  let zero := fresh in
  destruct (Rtotal_order e 0) as [?|[zero|?]]; [ clear h | rewrite (zero_quotient e s zero) in h | clear h ].

Lemma sign_of_quotient (e s : R) : 0 < e / s -> (0 < s -> 0 < e) /\ (s < 0 -> e < 0).
Proof.
  intros Q; split; intros S.
  - replace e with (e / s * s) by (field; lra); nra.
  - assert (E : e = e / s * s) by (field; lra); rewrite E; nra.
Qed.

Lemma sign_of_opposite_quotient (e s : R) : 0 < - (e / s) -> (0 < s -> e < 0) /\ (s < 0 -> 0 < e).
Proof.
  intros Q; assert (N : 0 < - e / s) by (replace (- e / s) with (- (e / s)) by (unfold Rdiv; ring); exact Q).
  destruct (sign_of_quotient _ _ N); split; intros S; [assert (0 < - e) by auto | assert (- e < 0) by auto]; lra.
Qed.

Lemma completed_square (p e q x : R) :
  - (4 * p * e) = q ^ 2 + x -> 0 < p -> (0 <= x -> e <= 0) /\ (0 < x -> e < 0).
Proof.
  intros E P; pose proof (pow2_ge_0 q); split; intros X.
  - destruct (Rle_lt_dec e 0) as [|N]; [assumption|]; assert (0 < p * e) by (now apply Rmult_lt_0_compat); lra.
  - destruct (Rlt_le_dec e 0) as [|N]; [assumption|]; assert (0 <= p * e) by (apply Rmult_le_pos; lra); lra.
Qed.

(** Cases by what the facts say and assume. *)
Ltac split_facts :=
  let g := fresh in
  first
    [ lra
    | lazymatch goal with
      | h : ?e / ?s = _ |- _ => zero_case h e s; split_facts
      | h : - (?e / ?s) = _ |- _ => zero_case h e s; split_facts
      | h : - (4 * ?p * ?e) = ?q ^ 2 + ?x |- _ =>
          assert (0 < p -> 0 <= x -> e <= 0) by apply (completed_square p e q x h);
          assert (0 < p -> 0 < x -> e < 0) by apply (completed_square p e q x h); clear h; split_facts
      | h : 0 < _ / _ |- _ => apply sign_of_quotient in h; destruct h; split_facts
      | h : 0 < - (_ / _) |- _ => apply sign_of_opposite_quotient in h; destruct h; split_facts
      | h : (?x < ?y) -> _ |- _ => destruct (Rlt_le_dec x y) as [g|g]; [specialize (h g); sign_of h | clear h]; split_facts
      | h : (?x <= ?y) -> _ |- _ => destruct (Rle_lt_dec x y) as [g|g]; [specialize (h g); sign_of h | clear h]; split_facts
      | h : (?x <> ?y) -> _ |- _ => destruct (Req_dec x y) as [g|g]; [clear h | specialize (h g); sign_of h]; split_facts
      | _ => timeout 20 nra
      end ].

Ltac by_cases := first [timeout 10 lra | timeout 60 (names; split_facts)].

(** ** At a point *)

(** A condition at a point, which may have roots there. *)
Ltac met := first [possible | interval with (i_prec 60)].
