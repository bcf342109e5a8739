//! The console: its start, its screen, its timers and its buttons.

use core::arch::global_asm;
use core::ptr::{read_volatile, write_volatile};

use luminaire_sprite::{Span, measures::SIDE, shown::LAMPS};

/// The width of the screen in pixels.
pub(crate) const WIDTH: usize = 240;
/// The height of the screen in pixels.
pub(crate) const HEIGHT: usize = 160;

// The header of a cartridge, and the start: it lets the cartridge wait as short as usual ones can, copies what is beside
// the processor, and the table to the other memory. The console compares 156 bytes of the header with its maker's logo,
// which is not here; emulators start without it. The check of the
// header, at 0xbd, is that of the command that writes the cartridge.
global_asm!(
    r#"
    .section .start, "ax"
    .arm
    .global start
start:
    b begin
    .space 156
    .ascii "LUMINAIRE\0\0\0"
    .ascii "CLME00"
    .byte 0x96, 0, 0
    .space 7
    .byte 0, 0
    .space 2
begin:
    ldr r0, =0x04000204
    ldr r1, =0x4317
    strh r1, [r0]
    ldr sp, =stack_top
    ldr r0, =near_from
    ldr r1, =near_start
    ldr r2, =near_end
    bl copy
    ldr r0, =far_from
    ldr r1, =far_start
    ldr r2, =far_end
    bl copy
    ldr r1, =bss_start
    ldr r2, =bss_end
    mov r3, #0
1:  cmp r1, r2
    strlo r3, [r1], #4
    blo 1b
    ldr r0, =main
    bx r0
copy:
    cmp r1, r2
    ldrlo r3, [r0], #4
    strlo r3, [r1], #4
    blo copy
    bx lr
    .pool
"#
);

/// What a picture was, for those who look at the console's memory: its number from 1 on, then the time, whether it was
/// lit point by point, and the cycles of drawing.
#[unsafe(link_section = ".mailbox")]
static mut MAILBOX: [u32; 4] = [0; 4];

const REGISTERS: usize = 0x0400_0000;
const SCREEN: usize = 0x0600_0000;
const PALETTE: usize = 0x0500_0200;
/// The memory of objects, of which the picture takes the first half.
const PICTURE: usize = 0x0601_4000;
const TILE: usize = 0x0601_6000;
/// The tile's number: tiles have 32 bytes.
const TILE_NUMBER: u16 = ((TILE - 0x0601_0000) / 32) as u16;
const OBJECTS: usize = 0x0700_0000;

/// A lamp of 8 x 8 pixels: its rows, from the left in the lowest four bits. 1 is the light's colour, 2 is white.
const LAMP: [u32; 8] =
    [0x0011_1100, 0x0111_1110, 0x1111_1111, 0x1112_2111, 0x1112_2111, 0x1111_1111, 0x0111_1110, 0x0011_1100];
/// Where the bar below the picture begins, and its rows.
const BAR: [usize; 2] = [8, 4];
const GREY: u16 = 0x2108;
const WHITE: u16 = 0x7fff;

fn write(address: usize, value: u16) {
    // SAFETY: the callers of this module name registers and memory of the display and of the timers, which Rust has not.
    unsafe { write_volatile(address as *mut u16, value) }
}

fn read(address: usize) -> u16 {
    // SAFETY: as above; reading has no effect.
    unsafe { read_volatile(address as *const u16) }
}

/// The console.
#[derive(Debug)]
pub(crate) struct Console {
    shown: u32,
    /// The mode of the bar on the screen.
    mode: Option<u32>,
}

impl Console {
    /// Sets up the screen, the objects and the timers.
    pub(crate) fn take() -> Self {
        // Mode 3, a bitmap of 15 bits, and objects.
        write(REGISTERS, 0x1403);
        // Two timers count cycles in 32 bits.
        write(REGISTERS + 0x106, 0x84);
        write(REGISTERS + 0x102, 0x80);
        for (i, row) in LAMP.into_iter().enumerate() {
            write(TILE + 4 * i, row as u16);
            write(TILE + 4 * i + 2, (row >> 16) as u16);
        }
        for (i, color) in LAMPS.into_iter().enumerate() {
            write(PALETTE + 32 * i + 2, color);
            write(PALETTE + 32 * i + 4, WHITE);
        }
        // Each of 128 objects is hidden until it has a place.
        for i in 0..128 {
            write(OBJECTS + 8 * i, 0x0200);
        }
        Self { shown: 0, mode: None }
    }

    /// The memory for a picture: that of the display has room beside the screen, and stores 16 bits at a time without
    /// waiting, as the memory beside the processor.
    pub(crate) fn picture(&mut self) -> &'static mut [u16; SIDE * SIDE] {
        // SAFETY: `take` is called once and this once; the memory is there, aligned, and nothing else uses it.
        unsafe { &mut *(PICTURE as *mut [u16; SIDE * SIDE]) }
    }

    /// The cycles since the start.
    pub(crate) fn cycles(&self) -> u32 {
        loop {
            let (high, low) = (read(REGISTERS + 0x104), read(REGISTERS + 0x100));
            if read(REGISTERS + 0x104) == high {
                return u32::from(high) << 16 | u32::from(low);
            }
        }
    }

    /// The refreshes of the display since the start.
    pub(crate) fn time(&self) -> u32 {
        self.cycles() / 280_896
    }

    /// Waits until the display is between two refreshes, and copies the opaque pixels of a picture to it. The lamps are at the pixels of the
    /// lights, and the bar below the picture has dots of the size of a pixel or of a cell.
    pub(crate) fn show(
        &mut self,
        picture: &[u16; SIDE * SIDE],
        spans: &[Span],
        [left, top]: [usize; 2],
        lights: [[i32; 2]; 2],
        [time, mode, cycles]: [u32; 3],
    ) {
        // All of this takes less than twelve lines of the 68 without a picture.
        while !(160..216).contains(&read(REGISTERS + 6)) {}
        for span in spans {
            let y = usize::from(span.y);
            // Pairs of pixels: those beside the opaque ones are black in both.
            let (start, end) = (usize::from(span.start) & !1, usize::from(span.end).next_multiple_of(2));
            let to = SCREEN + 2 * (WIDTH * (top + y) + left + start);
            copy(picture.get(SIDE * y + start..SIDE * y + end).unwrap_or_default(), to);
        }
        for (i, [x, y]) in lights.into_iter().enumerate() {
            // The console takes an object's place modulo 256 rows and 512 columns.
            let [x, y] = [(left as i32 + x - 4) as u16 & 0x1ff, (top as i32 + y - 4) as u16 & 0xff];
            let object = OBJECTS + 8 * i;
            write(object, y);
            write(object + 2, x);
            write(object + 4, (i as u16) << 12 | TILE_NUMBER);
        }
        if self.mode != Some(mode) {
            self.mode = Some(mode);
            bar([left, top + SIDE + BAR[0]], if mode == 0 { 4 } else { 1 });
        }
        self.shown += 1;
        // SAFETY: nothing else uses it.
        unsafe { write_volatile(&raw mut MAILBOX, [self.shown, time, mode, cycles]) }
    }
}

/// Draws a bar of dots of this width.
fn bar([left, top]: [usize; 2], width: usize) {
    for (y, x) in (0..BAR[1]).flat_map(|y| (0..SIDE).map(move |x| (y, x))) {
        let color = if (x / width + y / width).is_multiple_of(2) { WHITE } else { GREY };
        write(SCREEN + 2 * (WIDTH * (top + y) + left + x), color);
    }
}

/// Copies an even number of neighbouring pixels by the DMA, 32 bits at a time; the processor waits.
fn copy(row: &[u16], to: usize) {
    let (from, count) = (row.as_ptr() as usize, row.len() / 2);
    for (register, value) in [(0xd4, from), (0xd8, to), (0xdc, 0x8400_0000 | count)] {
        // SAFETY: the DMA reads the pixels, of which the first is at an even place and so aligned, and writes the memory of
        // the display.
        unsafe { write_volatile((REGISTERS + register) as *mut u32, value as u32) }
    }
}

/// The buttons.
#[derive(Debug, Default)]
pub(crate) struct Buttons {
    is_down: bool,
}

impl Buttons {
    /// Whether A is down and was not before.
    pub(crate) fn has_pressed_a(&mut self) -> bool {
        let was_down = self.is_down;
        self.is_down = read(REGISTERS + 0x130) & 1 == 0;
        self.is_down && !was_down
    }
}
