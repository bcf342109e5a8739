//! Operations with the same formula in both fixed-point formats.

/// Defines the items of `Arithmetic` that both fixed-point formats share.
///
/// `wide` is the integer type that stores the format's light and holds the products. Each format's
/// module supplies the module `lobe` and the function `factor`.
macro_rules! operations {
    (
        $bits:ident, $unsigned:ident, $wide:ident, $light:ident, $weight:ident, $gain:ident, $offset:ident, $frame:ident, $steps:ident
    ) => {
        type Position = Length;
        type Direction = Fx32;
        type Received = $light;
        type Versine = Versine;
        type Ramp = FixedRamp;
        type Weight = $weight;
        type Frame = $frame;
        type Gain = $gain;
        type Offset = $offset;

        #[inline]
        fn part(steps: u32) -> Self {
            Self::from_bits((steps << (Self::FRACTION_BITS - 14)) as $bits)
        }

        fn weight(value: f32) -> $weight {
            const ONE: f32 = $weight::ONE.to_bits() as f32;
            $weight::from_bits(rounded(value.clamp(-4.0, 4.0) * ONE) as _)
        }

        fn versine(ramp: FixedRamp, value: f32) -> Versine {
            if value.is_nan() { Versine::MAX } else { magnified(value, ramp.zoom) }
        }

        fn ramp(inner: f32, outer: f32, limit: f32) -> FixedRamp {
            FixedRamp::new(inner, outer, limit)
        }

        fn gain(value: f32) -> $gain {
            $gain::nearest(value)
        }

        #[inline]
        fn times(self, other: Self) -> Self {
            let [a, b] = [self, other].map(|scalar| $wide::from(scalar.to_bits() as $unsigned));
            let product =
                a.wrapping_mul(b).wrapping_add(1 << (Self::FRACTION_BITS - 1)) >> Self::FRACTION_BITS;
            Self::from_bits(product.min(1 << Self::FRACTION_BITS) as $bits)
        }

        #[inline]
        fn minus(self, other: Self) -> Self {
            self.saturating_sub(other)
        }

        /// The result is exact except for a single rounding at the end, so the function is
        /// monotone.
        #[inline]
        fn smooth(self) -> Self {
            const BITS: u32 = $light::FRACTION_BITS;
            let t = $wide::from(self.clamp(Self::ZERO, Self::ONE).to_bits() as $unsigned);
            let (square, factor) = (t * t, (3 << BITS) - 2 * t);
            let product = (square >> BITS) * factor + (((square & ((1 << BITS) - 1)) * factor) >> BITS);
            Self::from_bits(((product + (1 << (BITS - 1))) >> BITS) as $bits)
        }

        fn frame(vectors: [Vec3<f32>; 3], tangent: f32) -> $frame {
            $frame::new(vectors, tangent)
        }

        #[inline]
        fn place(frame: &$frame, light: Vec3<Length>, point: Vec3<Length>) -> ProjectedPoint<Self> {
            frame.place(light, point)
        }

        #[inline]
        fn power(versine: Self::Versine, exponent: u32) -> Self {
            lobe::power(versine, exponent)
        }

        fn enclosing(a: Vec3<Length>, b: Vec3<Length>) -> (Vec3<Length>, Length) {
            sphere::enclosing(a, b)
        }

        fn moved_back(
            tip: Vec3<Length>,
            axis: Vec3<Fx32>,
            bound: Self,
            radius: Length,
        ) -> Option<Vec3<Length>> {
            let squared_sine = Self::ONE.minus(bound).minus(Self::from_bits(OUTSIDE + 1));
            let thirty_bits =
                u32::from(squared_sine.to_bits().max(0) as $unsigned) << (30 - Self::FRACTION_BITS);
            (bound > Self::ZERO).then(|| sphere::moved_back(tip, axis, thirty_bits, radius)).flatten()
        }

        #[inline]
        fn offset_along(direction: Vec3<Fx32>) -> $offset {
            $offset::new(direction.map(Fx32::to_bits))
        }

        #[inline]
        fn unit_of_bytes(bytes: [i8; 3]) -> Vec3<Fx32> {
            bytes.map(|c| Fx32::from_bits(i32::from(c) << 23)).into()
        }

        #[inline]
        fn unit_normal(unit: Vec3<Fx32>) -> Vec3<Self> {
            let more = Fx32::FRACTION_BITS - Self::FRACTION_BITS;
            unit.map(|c| Self::from_bits(((c.to_bits() + ((1 << more) >> 1)) >> more) as $bits))
        }

        #[inline]
        fn normal_unit(normal: Vec3<Self>) -> Vec3<Fx32> {
            normal.map(|c| {
                Fx32::from_bits(i32::from(c.to_bits()) << (Fx32::FRACTION_BITS - Self::FRACTION_BITS))
            })
        }

        #[inline]
        fn mirror(direction: Vec3<Fx32>, normal: Vec3<Self>) -> Vec3<Fx32> {
            lobe::mirror(direction, normal)
        }

        #[inline]
        fn direction_between(a: Vec3<Fx32>, b: Vec3<Fx32>) -> Vec3<Fx32> {
            // Half the difference of two components always fits 32 bits.
            let difference = b.zip(a, |b, a| (b.to_bits() >> 1) - (a.to_bits() >> 1));
            Ray::<Self>::direction(&$offset::new(difference).ray())
        }

        #[inline]
        fn incidence(direction: Vec3<Fx32>, normal: Vec3<Self>) -> Self {
            lobe::incidence(direction, normal)
        }

        #[inline]
        fn expose(self, gain: $gain) -> $light {
            $light::shifted(factor(self) * gain.factor(), gain.scale())
        }

        #[inline]
        fn filter(light: $light, color: Self) -> $light {
            const HALF: u32 = $wide::BITS / 2;
            let color = $wide::from(color.to_bits().max(0) as $unsigned);
            let (high, low) = (light.to_bits() >> HALF, light.to_bits() & ((1 << HALF) - 1));
            let high = high * color;
            let high = if high >> ($wide::BITS - 2) == 0 { high << 2 } else { $wide::MAX };
            let low = (low * color + (1 << (Self::FRACTION_BITS - 1))) >> Self::FRACTION_BITS;
            $light::from_bits(high.saturating_add(low))
        }

        #[inline]
        fn add_light(a: $light, b: $light) -> $light {
            a.saturating_add(b)
        }

        #[inline]
        fn light_to_gain(light: $light) -> $gain {
            $gain::normalised(light.to_bits(), $light::FRACTION_BITS as i32)
        }

        #[inline]
        fn amplify(light: $light, gain: $gain) -> $light {
            gain.amplify(light)
        }

        #[inline]
        fn light_steps(light: $light) -> u32 {
            (light.to_bits() >> ($light::FRACTION_BITS - 14)).try_into().unwrap_or(u32::MAX)
        }

        #[inline]
        fn clip(light: $light) -> Self {
            Self::from_bits(light.to_bits().min(1 << Self::FRACTION_BITS) as $bits)
        }

        #[inline]
        fn word(self) -> Word {
            Word::$steps(self.to_bits())
        }
    };
}

pub(in crate::number) use operations;
