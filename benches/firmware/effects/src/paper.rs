/// The pure colours of electronic paper of seven colours.
const PAPER: [Rgb<u8>; 7] = [
    Rgb::new(0, 0, 0),
    Rgb::new(255, 255, 255),
    Rgb::new(0, 255, 0),
    Rgb::new(0, 0, 255),
    Rgb::new(255, 0, 0),
    Rgb::new(255, 255, 0),
    Rgb::new(255, 128, 0),
];
