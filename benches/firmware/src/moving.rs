//! Frames in which the light of the stage moves: their checksums, without markers.

use luminaire_stage::{CHECKSUM, FRAMES, Stage, checksum};

use crate::board::println;

/// Prints the checksum of every eighth frame of the light's movement.
pub fn moving() {
    let mut stage = Stage::<160>::default();
    let mut pixels = [0; 160];
    for frame in (0..FRAMES).step_by(8) {
        stage.turn_to(frame);
        let mut sum = CHECKSUM;
        for row in 0..120 {
            stage.draw::<()>(row, &mut pixels);
            sum = checksum(sum, &pixels);
        }
        println!("frame {frame}: checksum {sum:08x}");
    }
}
