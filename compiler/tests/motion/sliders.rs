//! Slider-cranks, the quick return and racks against closed forms.
