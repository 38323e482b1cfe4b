//! How a table goes on between its knots and outside of them.

/// What stands between the knots of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight lines.
    Linear,
    /// Akima, J. ACM 17 (1970) 589.
    Akima,
    /// The same with weights that keep flat stretches flat.
    ModifiedAkima,
    /// Steffen, Astronomy and Astrophysics 239 (1990) 443: no value beyond those of the knots beside it.
    Monotone,
    /// Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300, with the ends of Moler, as in SciPy.
    Pchip,
    /// The spline whose first and last two pieces are one.
    Cubic,
    /// The spline that is straight at both ends.
    Natural,
    /// The spline that repeats itself.
    Periodic,
    /// Of two arguments: straight along both.
    Bilinear,
    /// Of two arguments: along both the spline of [`Cubic`](Self::Cubic).
    Bicubic,
}

impl Interpolation {
    pub const ALL: [Interpolation; 10] = [
        Self::Linear,
        Self::Akima,
        Self::ModifiedAkima,
        Self::Monotone,
        Self::Pchip,
        Self::Cubic,
        Self::Natural,
        Self::Periodic,
        Self::Bilinear,
        Self::Bicubic,
    ];

    /// As written.
    pub fn word(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Akima => "akima",
            Self::ModifiedAkima => "modified_akima",
            Self::Monotone => "monotone",
            Self::Pchip => "pchip",
            Self::Cubic => "cubic",
            Self::Natural => "natural",
            Self::Periodic => "periodic",
            Self::Bilinear => "bilinear",
            Self::Bicubic => "bicubic",
        }
    }

    /// How many arguments it is for.
    pub fn arguments(self) -> usize {
        if matches!(self, Self::Bilinear | Self::Bicubic) { 2 } else { 1 }
    }

    /// What is taken where no word says it.
    pub fn of(arguments: usize) -> Self {
        if arguments == 2 { Self::Bilinear } else { Self::Monotone }
    }

    /// The fewest knots that determine it.
    pub fn fewest(self) -> usize {
        if matches!(self, Self::Cubic | Self::Natural | Self::Bicubic) { 4 } else { 2 }
    }

    /// How often it can be differentiated with what comes out still continuous.
    pub fn smoothness(self) -> usize {
        match self {
            Self::Linear | Self::Bilinear => 0,
            Self::Akima | Self::ModifiedAkima | Self::Monotone | Self::Pchip => 1,
            Self::Cubic | Self::Natural | Self::Periodic | Self::Bicubic => 2,
        }
    }
}

/// How a table goes on outside of its knots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// With value and slope at the end.
    Linear,
    /// With the value at the end.
    Hold,
}

impl Outside {
    pub const ALL: [Outside; 2] = [Self::Linear, Self::Hold];

    /// As written.
    pub fn word(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Hold => "hold",
        }
    }
}
