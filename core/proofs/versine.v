(* The versine of a direction and an axis that are both wrong: the lemma of `bound.rs`.

   l and s are the exact unit vectors, e and f the relative errors of their lengths, and d the difference of
   their errors across themselves. The computed versine, half the square of the difference, is then that of
   w = l - s and (e + f) v + w.d, and half the square of e l - f s + d. *)
Require Import Reals Lra.
Open Scope R_scope.

Definition dot a b c x y z := a * x + b * y + c * z.
Definition square a b c := dot a b c a b c.

Lemma versine :
  forall l1 l2 l3 s1 s2 s3 d1 d2 d3 e f,
  square l1 l2 l3 = 1 -> square s1 s2 s3 = 1 ->
  let v := square (l1 - s1) (l2 - s2) (l3 - s3) / 2 in
  square ((1 + e) * l1 - (1 + f) * s1 + d1) ((1 + e) * l2 - (1 + f) * s2 + d2)
    ((1 + e) * l3 - (1 + f) * s3 + d3) / 2
  = v + (e + f) * v + dot (l1 - s1) (l2 - s2) (l3 - s3) d1 d2 d3
    + square (e * l1 - f * s1 + d1) (e * l2 - f * s2 + d2) (e * l3 - f * s3 + d3) / 2.
Proof.
  intros l1 l2 l3 s1 s2 s3 d1 d2 d3 e f one_l one_s v.
  transitivity (v + (e + f) * v + dot (l1 - s1) (l2 - s2) (l3 - s3) d1 d2 d3
    + square (e * l1 - f * s1 + d1) (e * l2 - f * s2 + d2) (e * l3 - f * s3 + d3) / 2
    + (e - f) * (square l1 l2 l3 - square s1 s2 s3) / 2).
  - unfold v, square, dot. field.
  - rewrite one_l, one_s. field.
Qed.
