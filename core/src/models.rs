//! The lists of the models: each is declared here once, and everything that is made for each of them
//! comes from its row.

/// The list of the falloffs that can be chosen at run time: hands its rows, each with a sample, to a
/// macro after the macro's own arguments.
macro_rules! falloffs {
    ($consumer:ident! $($arguments:tt)*) => {
        $consumer! {
            $($arguments)*
            /// A step.
            Step(Step) = "cut-off", Ok(Step);
            /// The straight ramp.
            Linear(Linear) = "linear", Ok(Linear);
            /// The square.
            Soft(Soft) = "soft", Ok(Soft);
            /// The mirror image of the square.
            Hard(Hard) = "hard", Ok(Hard);
            /// Smoothstep.
            Smooth(Smooth) = "smooth", Ok(Smooth);
            /// A quadratic between soft and hard.
            Quadratic(Quadratic) = "blend", Quadratic::new(0.5);
            /// A monotone cubic.
            Cubic(Cubic) = "cubic", Cubic::with_slopes(1.25, 3.5);
            /// An integer power.
            Power(IntegerPower) = "power", IntegerPower::new(15);
            /// An inverted integer power.
            InvertedPower(InvertedIntegerPower) = "rim", InvertedIntegerPower::new(4);
            /// A mixture of two powers.
            MixedPower(MixedPower) = "mixed-power", MixedPower::new([1, 16], 0.375);
            /// A mixture of two inverted powers.
            InvertedMixedPower(InvertedMixedPower) = "mixed-rim", InvertedMixedPower::new([2, 3], 0.5625);
            /// A power of a real exponent.
            RealPower(RealPower) = "real-power", RealPower::new(2.2);
            /// An inverted power of a real exponent.
            InvertedRealPower(InvertedRealPower) = "real-rim", InvertedRealPower::new(0.75);
            /// Samples.
            Table(Table<'static>) = "table", Ok(Table::of(&[
                65_535, 65_000, 63_211, 60_007, 51_234, 39_876, 24_321, 11_111, 3_210, 0,
            ]));
        }
    };
}

/// The list of the attenuations that can be chosen at run time: hands its rows to a macro, after the
/// macro's own arguments.
macro_rules! attenuations {
    ($consumer:ident! $($arguments:tt)*) => {
        $consumer! {
            $($arguments)*
            /// No attenuation, cut off.
            Constant(CutAt<NoAttenuation>),
            /// The inverse-square law, cut off.
            InverseSquare(CutAt<InverseSquare>),
            /// One over a polynomial, cut off.
            Polynomial(CutAt<Polynomial>),
            /// The inverse-square law in glTF's window.
            GltfRange(GltfRange),
            /// No attenuation, faded out.
            WindowedConstant(Windowed<NoAttenuation>),
            /// The inverse-square law, faded out.
            FilamentRange(FilamentRange),
            /// One over a polynomial, faded out.
            WindowedPolynomial(Windowed<Polynomial>),
            /// Smoothstep to a range.
            SmoothRange(SmoothRange),
        }
    };
}

pub(crate) use {attenuations, falloffs};
