#pragma once
/// The elementary functions whose results reach a state. The standard library's own are not used for that:
/// glibc picks between variants by the processor's features, and their last bits differ; so do those of other
/// libraries and of other releases. These are a fixed sequence of additions, multiplications, divisions and
/// square roots, which IEEE 754 rounds in one way only. So the bits are the same for every processor and
/// compiler, as long as the compiler contracts nothing (-ffp-contract=off, cmake/flipside.cmake).
///
/// Errors are bounds over all finite arguments, in units of the last place of the result (ulp), where that is
/// not subnormal; there they are one more. math_test.cpp measures them. Special values are as in C's Annex F.
/// None throws, allocates, or sets errno.

namespace flipside::math {

struct SineCosine {
    double sine = 0, cosine = 0;
};

/// Both at once costs little more than one. Error below 0.9 ulp, for arguments of any size.
[[nodiscard]] SineCosine sincos(double angle);
/// Error below 0.9 ulp.
[[nodiscard]] double sin(double angle);
[[nodiscard]] double cos(double angle);
/// Angle of the vector (x, y), in [−π, π]. Error below 0.6 ulp.
[[nodiscard]] double atan2(double y, double x);
/// e^x − 1. Error below 0.9 ulp.
[[nodiscard]] double expm1(double x);
/// ln(1 + x). Error below 0.6 ulp.
[[nodiscard]] double log1p(double x);
/// The positive n-th root of x ≥ 0, for n ≥ 1; NaN for negative x. Error below 0.8 ulp.
[[nodiscard]] double root(double x, int n);

}  // namespace flipside::math
