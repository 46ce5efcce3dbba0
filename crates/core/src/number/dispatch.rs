//! Runs a loop compiled for the widest vector unit of the machine; the only `unsafe` of the crate.
//!
//! Every version executes the same IEEE operations in the same order (no contraction), so the bits are the same.

/// A loop whose `run` must be `#[inline(always)]`, so that it is compiled anew for each vector unit.
pub trait Kernel {
    /// Does the work.
    fn run(self);
}

/// Runs the kernel with AVX-512 or AVX2 where the machine has them, plainly elsewhere.
pub fn run_on_widest_unit<K: Kernel>(kernel: K) {
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("avx512bw")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("fma")
        {
            // SAFETY: the features that the function is compiled for have just been detected.
            return unsafe { run_with_avx512(kernel) };
        }
        if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            // SAFETY: as above.
            return unsafe { run_with_avx2(kernel) };
        }
    }
    kernel.run();
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512bw,avx512dq,fma")]
fn run_with_avx512<K: Kernel>(kernel: K) {
    kernel.run();
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn run_with_avx2<K: Kernel>(kernel: K) {
    kernel.run();
}
