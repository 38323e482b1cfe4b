//! The definition that a model carries is what stands in the file.

linkwright::mechanism! {
    // How a slider is written,
    pub planar Slider { // and where its brace stands,
        /* stays: */ rod   bar { mass [kg] = 1; length [m] = 1; } // ends of lines, too.
        joint rail: prismatic(ground(0, 0) [m],
                              bar.center, axis = (1, 0));
    }
}

macro_rules! written_by_a_macro {
    ($name:ident, $mass:literal) => {
        linkwright::mechanism! {
            // Nobody sees this.
            planar $name {
                rod bar { mass [kg] = $mass; length [m] = 1; }
                joint rail: prismatic(ground(0, 0) [m], bar.center, axis = (1, 0));
            }
        }
    };
}
written_by_a_macro!(Written, 2);

#[test]
fn comments_and_lines_are_kept() {
    let expected = "pub planar Slider { // and where its brace stands,
    /* stays: */ rod   bar { mass [kg] = 1; length [m] = 1; } // ends of lines, too.
    joint rail: prismatic(ground(0, 0) [m],
                          bar.center, axis = (1, 0));
}";
    assert_eq!(Slider::SOURCE, expected);
}

#[test]
fn what_a_macro_wrote_is_its_tokens() {
    assert!(Written::SOURCE.contains("mass [kg] = 2"), "{}", Written::SOURCE);
    assert!(!Written::SOURCE.contains("Nobody"), "{}", Written::SOURCE);
}
