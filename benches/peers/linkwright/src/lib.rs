//! Linkwright's side of the comparison: the interface of `../interface/peer.h`, and what others start from: definitions,
//! consistent states and the motion of the bodies in them.
//!
//! A model is asked for by its name. What is timed is in `timed.rs`, states are made in `states.rs`, batches run in `batch.rs`.

mod batch;
mod states;
mod timed;

use std::ffi::{CStr, CString, c_char, c_double, c_int, c_long};
use timed::{Of, Timed};

/// A mechanism with everything that is asked of it.
pub struct Peer(Box<dyn Timed>);

macro_rules! models {
    ($($name:literal: $model:path, $pace:literal, $inputs:literal;)*) => {
        fn open(name: &str) -> Option<Peer> {
            match name {
                $($name => Some(Peer(Box::new(Of::<$model>::new(
                    $pace,
                    [0.0; $inputs],
                    |model, state, a| {
                        use linkwright::Fields;
                        model.motions(0.0, &state.q, &state.v, a).iter().flat_map(|body| body.to_array()).collect()
                    },
                )))),)*
                _ => None,
            }
        }

        /// Definition and source.
        fn texts(name: &str) -> Option<[&'static str; 2]> {
            match name {
                $($name => Some([<$model>::DEFINITION, <$model>::SOURCE]),)*
                _ => None,
            }
        }
    };
}

// Name, model, seconds between states along its motion, number of inputs.
models! {
    "double_pendulum": linkwright_models::double_pendulum::DoublePendulum, 0.05, 0;
    "four_bar": linkwright_models::four_bar::FourBar, 0.05, 0;
    "n_four_bar_10": linkwright_models::n_four_bar::NFourBar10, 0.05, 0;
    "n_four_bar_40": linkwright_models::n_four_bar::NFourBar40, 0.05, 0;
    "andrews": linkwright_models::andrews::Andrews, 4e-4, 0;
    "panda": linkwright_models::panda::Panda, 0.01, 7;
    "bricard": linkwright_models::bricard::Bricard, 0.05, 0;
}

/// The text behind a pointer.
///
/// # Safety
/// It ends with zero.
unsafe fn text<'t>(pointer: *const c_char) -> &'t str {
    // SAFETY: the caller's.
    unsafe { CStr::from_ptr(pointer) }.to_str().unwrap_or_default()
}

/// The definition (0) or the source (1) of a model, for as long as the program runs; null where there is none.
///
/// # Safety
/// `name` ends with zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn linkwright_text(name: *const c_char, which: c_int) -> *const c_char {
    // SAFETY: the caller's.
    let found = texts(unsafe { text(name) }).and_then(|texts| CString::new(*texts.get(which as usize)?).ok());
    found.map_or(std::ptr::null(), |text| text.into_raw().cast_const())
}

/// # Safety
/// `model` ends with zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn peer_open(model: *const c_char) -> *mut Peer {
    // SAFETY: the caller's.
    open(unsafe { text(model) }).map_or(std::ptr::null_mut(), |peer| Box::into_raw(Box::new(peer)))
}

/// # Safety
/// `peer` comes from `peer_open`, like in all that follow; there are two places.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn peer_sizes(peer: *const Peer, positions: *mut c_int, velocities: *mut c_int) {
    // SAFETY: the caller's.
    unsafe {
        let [q, v] = (*peer).0.sizes();
        *positions = q as c_int;
        *velocities = v as c_int;
    }
}

/// # Safety
/// There are `count` rows of positions and velocities.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn peer_give(peer: *mut Peer, count: c_int, rows: *const c_double) {
    // SAFETY: the caller's.
    unsafe {
        let peer = &mut (*peer).0;
        let width: usize = peer.sizes().iter().sum();
        peer.give(std::slice::from_raw_parts(rows, count as usize * width));
    }
}

/// # Safety
/// There is place for a row of accelerations for each state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn peer_accelerations(peer: *mut Peer, rows: *mut c_double) {
    // SAFETY: the caller's.
    unsafe {
        let found = (*peer).0.accelerations();
        rows.copy_from_nonoverlapping(found.as_ptr(), found.len());
    }
}

/// # Safety
/// States were given.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn peer_evaluate(peer: *mut Peer, first: c_int, count: c_int) {
    // SAFETY: the caller's.
    unsafe { (*peer).0.evaluate(first as usize, count as usize) }
}

/// # Safety
/// States were given.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn peer_chain(peer: *mut Peer, count: c_int) {
    // SAFETY: the caller's.
    unsafe { (*peer).0.chain(count as usize) }
}

/// # Safety
/// `row` has positions and velocities.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn peer_simulate(
    peer: *mut Peer,
    step: c_double,
    steps: c_long,
    row: *mut c_double,
) -> c_long {
    // SAFETY: the caller's.
    unsafe {
        let peer = &mut (*peer).0;
        let width: usize = peer.sizes().iter().sum();
        peer.simulate(step, steps as usize, std::slice::from_raw_parts_mut(row, width)) as c_long
    }
}

/// # Safety
/// A live peer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn peer_batch(
    peer: *mut Peer,
    members: c_int,
    threads: c_int,
    step: c_double,
    steps: c_long,
) -> c_double {
    // SAFETY: the caller's.
    unsafe { (*peer).0.batch(members as usize, threads as usize, step, steps as usize) }
}

/// How many numbers describe the motion of all bodies.
///
/// # Safety
/// A live peer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn linkwright_motions(peer: *mut Peer) -> c_int {
    // SAFETY: the caller's.
    unsafe { (*peer).0.start_motions().len() as c_int }
}

/// Consistent states: along the motion, or at random where `seed` is not zero; each with the motion of its bodies.
///
/// # Safety
/// There is place for `count` rows of positions, velocities, accelerations, and of motions.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn linkwright_states(
    peer: *mut Peer,
    seed: u64,
    count: c_int,
    rows: *mut c_double,
    accelerations: *mut c_double,
    motions: *mut c_double,
) {
    // SAFETY: the caller's.
    unsafe {
        let [states, a, bodies] = (*peer).0.states(seed, count as usize);
        rows.copy_from_nonoverlapping(states.as_ptr(), states.len());
        accelerations.copy_from_nonoverlapping(a.as_ptr(), a.len());
        motions.copy_from_nonoverlapping(bodies.as_ptr(), bodies.len());
    }
}

/// The motion of the bodies in a state.
///
/// # Safety
/// `row` has positions and velocities; there is place for `linkwright_motions` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn linkwright_bodies(peer: *mut Peer, row: *const c_double, motions: *mut c_double) {
    // SAFETY: the caller's.
    unsafe {
        let peer = &(*peer).0;
        let width: usize = peer.sizes().iter().sum();
        let bodies = peer.motions_of(std::slice::from_raw_parts(row, width));
        motions.copy_from_nonoverlapping(bodies.as_ptr(), bodies.len());
    }
}
