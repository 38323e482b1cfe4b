//! Random calls of the runtime, as many as wanted: `--cases 200000 --seed 1`. What is judged is in `tests/runtime_fuzz`.

#[path = "judge.rs"]
mod judge;
#[path = "methods.rs"]
mod methods;
#[path = "models.rs"]
mod models;
#[path = "random.rs"]
mod random;

fn main() {
    let argument = |name: &str, otherwise: u64| {
        let mut arguments = std::env::args().skip_while(|argument| argument != name).skip(1);
        arguments.next().map_or(otherwise, |value| value.parse().expect("a whole number"))
    };
    let (cases, seed, from) = (argument("--cases", 10_000), argument("--seed", 1), argument("--from", 0));
    std::panic::set_hook(Box::new(|_| ()));
    let (mut total, mut faults) = (judge::Verdict::default(), 0_u64);
    for number in from..from + cases {
        match judge::judge(seed, number) {
            Ok(verdict) => {
                total.calls += verdict.calls;
                total.good += verdict.good;
            }
            Err(fault) => {
                faults += 1;
                println!("seed {seed}, case {number}: {fault}");
            }
        }
    }
    println!("{cases} cases, {} calls, {} of them Ok, {faults} faults", total.calls, total.good);
    std::process::exit(i32::from(faults > 0));
}
