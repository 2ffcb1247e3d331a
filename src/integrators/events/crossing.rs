use core::cmp::Ordering;

/// Which way a function crosses zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// From g < 0 to g ≥ 0.
    Rising,
    /// From g > 0 to g ≤ 0.
    Falling,
}

/// What counts as an event of one function g(t, x).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crossing {
    /// The direction asked for; `None` is either.
    direction: Option<Direction>,
    terminal: bool,
}

impl Crossing {
    /// From g < 0 to g ≥ 0.
    pub fn rising() -> Self {
        Self { direction: Some(Direction::Rising), terminal: false }
    }

    /// From g > 0 to g ≤ 0.
    pub fn falling() -> Self {
        Self { direction: Some(Direction::Falling), terminal: false }
    }

    /// Either way.
    pub fn both() -> Self {
        Self { direction: None, terminal: false }
    }

    /// The same, and the solver stops there.
    pub fn terminal(self) -> Self {
        Self { terminal: true, ..self }
    }

    pub(super) fn is_terminal(&self) -> bool {
        self.terminal
    }

    pub(super) fn wants(&self, direction: Direction) -> bool {
        self.direction.is_none_or(|wanted| wanted == direction)
    }
}

/// The crossing from a side of zero, `Less` or `Greater`, to a value that is `now`; none from zero itself.
pub(super) fn crossed(side: Ordering, now: Ordering) -> Option<Direction> {
    match (side, now) {
        (Ordering::Less, Ordering::Equal | Ordering::Greater) => Some(Direction::Rising),
        (Ordering::Greater, Ordering::Equal | Ordering::Less) => Some(Direction::Falling),
        _ => None,
    }
}

checked! {
    [] Crossing<>, [] { direction: Option<Direction>, terminal: bool } =>
    Ok(Self { direction, terminal })
}
