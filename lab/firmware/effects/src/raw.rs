//! Values of any bits, for the programs that are linked to show that nothing panics.

use core::array::from_fn;
use core::hint::black_box;

use luminaire::codegen::{FloatFrame, FloatRamp, Frame16, Frame32, Gain16, Gain32, Ramp16, Ramp32};
use luminaire::number::{Length, Light16, Light32, Weight16, Weight32};
use luminaire::{
    Fx16, Fx32, Rgb, Scalar, Vec3,
    attenuation::{AnyAttenuation, Attenuation, NoAttenuation},
    falloff::{AnyFalloff, Cubic, Falloff, Knot, Linear, Quadratic, Table},
    light::{CompiledCone, CompiledPointLight, CompiledSpotLight},
};

const SAMPLES: [u16; 5] = [65_535, 60_000, 31_000, 400, 0];
const KNOTS: [Knot; 2] = [Knot::from_bits(0, 65_535, -65_535), Knot::from_bits(32_768, 32_768, i32::MIN)];

/// Bits that the compiler does not know.
#[derive(Debug)]
pub struct Bits {
    words: [u64; 64],
    next: u8,
}

impl Bits {
    /// These bits.
    pub fn new(words: [u64; 64]) -> Self {
        Self { words, next: 0 }
    }

    /// The next of them.
    #[inline(never)]
    pub fn word(&mut self) -> u64 {
        self.next = self.next.wrapping_add(1);
        self.words[usize::from(self.next % 64)]
    }

    /// Any number in `f32`.
    pub fn float(&mut self) -> f32 {
        f32::from_bits(self.word() as u32)
    }

    /// Any integer.
    pub fn integer(&mut self) -> u32 {
        self.word() as u32
    }

    /// A random index below `choices`.
    pub fn choice(&mut self, choices: u64) -> u64 {
        self.word() % choices
    }

    /// A vector of any bits.
    pub fn vector<T>(&mut self, make: impl Fn(u64) -> T) -> Vec3<T> {
        Vec3::new(make(self.word()), make(self.word()), make(self.word()))
    }

    /// A colour of any bits.
    pub fn color<T>(&mut self, make: impl Fn(u64) -> T) -> Rgb<T> {
        Rgb::new(make(self.word()), make(self.word()), make(self.word()))
    }

    /// A quadratic of any bits.
    pub fn any_quadratic(&mut self) -> Quadratic {
        Quadratic::from_bits(self.word() as u32)
    }

    /// A cubic of any bits.
    pub fn any_cubic(&mut self) -> Cubic {
        Cubic::from_bits([self.word() as u32, self.word() as u32])
    }

    /// A table of samples that the compiler does not know.
    pub fn any_table() -> Table<'static> {
        Table::new(black_box(SAMPLES.as_slice())).unwrap_or(Table::of(&SAMPLES))
    }

    /// A table of knots that the compiler does not know.
    pub fn any_knots() -> Table<'static> {
        Table::of_knots(black_box(&KNOTS))
    }

    /// Any profile; the straight ramp in place of one that is refused.
    #[inline(never)]
    pub fn any_profile(&mut self) -> AnyFalloff {
        let made = match self.choice(3) {
            0 => Ok(Self::any_table().into()),
            1 => Ok(Self::any_knots().into()),
            _ => AnyFalloff::drawn(self.integer() as usize, || self.float()),
        };
        made.unwrap_or(AnyFalloff::Linear(Linear))
    }

    /// An array of any bits.
    pub fn column<T, const N: usize>(&mut self, make: impl Fn(u64) -> T) -> [T; N] {
        from_fn(|_| make(self.word()))
    }

    /// Arrays of any bits, one for each component.
    pub fn columns<T, const N: usize>(&mut self, make: impl Fn(u64) -> T + Copy) -> Vec3<[T; N]> {
        Vec3::new(self.column(make), self.column(make), self.column(make))
    }

    /// The colour of a light, and that of its highlights.
    pub fn colors<S: Raw>(&mut self) -> [Rgb<S>; 2] {
        [self.color(S::scalar), self.color(S::scalar)]
    }

    /// A spotlight of this profile, which need not be that of the curve, and of any bits.
    pub fn any_spot<S: Raw, P: Falloff, A: Attenuation>(
        &mut self,
        profile: P,
        curve: P::Compiled<S>,
        attenuation: A::Constants<S>,
    ) -> CompiledSpotLight<S, P, A> {
        let falloff = CompiledCone::from_parts(S::raw_ramp(self), profile, curve);
        let (position, axis) = (self.vector(S::raw_length), self.vector(S::unit));
        let (outside, intensity) = (S::scalar(self.word()), S::raw_gain(self.word()));
        CompiledSpotLight::from_parts(
            position,
            axis,
            falloff,
            outside,
            attenuation,
            intensity,
            self.integer(),
            self.colors(),
        )
    }

    /// A point light of any bits.
    pub fn any_point<S: Raw, A: Attenuation>(
        &mut self,
        attenuation: A::Constants<S>,
    ) -> CompiledPointLight<S, A> {
        let (position, intensity) = (self.vector(S::raw_length), S::raw_gain(self.word()));
        CompiledPointLight::from_parts(position, attenuation, intensity, self.integer(), self.colors())
    }

    /// Any range, or none.
    pub fn any_range(&mut self) -> Option<f32> {
        (self.choice(2) == 0).then(|| self.float())
    }

    /// Any attenuation; none in place of one that is refused.
    #[inline(never)]
    pub fn any_distance(&mut self) -> AnyAttenuation {
        let made = AnyAttenuation::drawn(self.integer() as usize, || self.float());
        made.unwrap_or(NoAttenuation.into())
    }
}

/// The arrays, borrowed.
pub fn each<T, const N: usize>(columns: &Vec3<[T; N]>) -> Vec3<&[T; N]> {
    Vec3::new(&columns.x, &columns.y, &columns.z)
}

/// A format whose values are made of any bits.
pub trait Raw: Scalar {
    /// A scalar.
    fn scalar(bits: u64) -> Self;
    /// A world coordinate.
    fn raw_length(bits: u64) -> Self::Length;
    /// A component of a direction.
    fn unit(bits: u64) -> Self::Unit;
    /// A coefficient of a profile.
    fn raw_weight(bits: u64) -> Self::Weight;
    /// A gain.
    fn raw_gain(bits: u64) -> Self::Gain;
    /// Light.
    fn light(bits: u64) -> Self::Irradiance;
    /// A ramp.
    fn raw_ramp(bits: &mut Bits) -> Self::Ramp;
    /// A frame.
    fn raw_frame(bits: &mut Bits) -> Self::Frame;
}

macro_rules! raw {
    ($format:ty, $weight:ident, $gain:ident, $light:ident, $ramp:ident, $frame:ident) => {
        impl Raw for $format {
            fn scalar(bits: u64) -> Self {
                Self::from_bits(bits as _)
            }

            fn raw_length(bits: u64) -> Length {
                Length::from_bits(bits as _)
            }

            fn unit(bits: u64) -> Fx32 {
                Fx32::from_bits(bits as _)
            }

            fn raw_weight(bits: u64) -> $weight {
                $weight::from_bits(bits as _)
            }

            fn raw_gain(bits: u64) -> $gain {
                $gain::from_bits([bits as _, (bits >> 32) as _])
            }

            fn light(bits: u64) -> $light {
                $light::from_bits(bits as _)
            }

            fn raw_ramp(bits: &mut Bits) -> $ramp {
                $ramp::from_bits(core::array::from_fn(|_| bits.word() as _))
            }

            fn raw_frame(bits: &mut Bits) -> $frame {
                $frame::from_bits(core::array::from_fn(|_| bits.word() as _))
            }
        }
    };
}

raw!(Fx16, Weight16, Gain16, Light16, Ramp16, Frame16);
raw!(Fx32, Weight32, Gain32, Light32, Ramp32, Frame32);

impl Raw for f32 {
    fn scalar(bits: u64) -> f32 {
        f32::from_bits(bits as u32)
    }

    fn raw_length(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn unit(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn raw_weight(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn raw_gain(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn light(bits: u64) -> f32 {
        Self::scalar(bits)
    }

    fn raw_ramp(bits: &mut Bits) -> FloatRamp {
        FloatRamp::from_bits(core::array::from_fn(|_| bits.word() as u32))
    }

    fn raw_frame(bits: &mut Bits) -> FloatFrame {
        FloatFrame::from_bits(core::array::from_fn(|_| bits.word() as u32))
    }
}
