//! Programs that do not link if they can panic. Two libraries share this file.

/// Makes a program that does its work again and again. It does not link if the work can panic: its
/// panic handler calls a function that is defined nowhere.
#[macro_export]
macro_rules! without_panic {
    ($work:expr) => {
        #[cfg(target_os = "none")]
        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
            unsafe extern "C" {
                safe fn a_panic_is_reachable() -> !;
            }
            a_panic_is_reachable()
        }

        #[cfg_attr(all(target_os = "none", target_arch = "arm"), cortex_m_rt::entry)]
        #[cfg_attr(all(target_os = "none", target_arch = "riscv32"), riscv_rt::entry)]
        #[cfg(target_os = "none")]
        fn start() -> ! {
            loop {
                $work;
            }
        }

        #[cfg(not(target_os = "none"))]
        fn main() {
            $work;
        }
    };
}
