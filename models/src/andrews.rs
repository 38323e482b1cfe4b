//! Andrews' squeezing mechanism, with the data of the IVP test set and with those of the IFToMM library (A03).
//!
//! Source: Test Set for Initial Value Problem Solvers, *Andrews' squeezing mechanism* (index 3), after Giles, Manning and
//! Schiehlen; IFToMM library of computational benchmark problems, A03. Data: seven bodies about a crank of 7 mm, a spring
//! of 4530 N/m and 77.85 mm free length that pushes and pulls, a torque of 0.033 N m on the crank, no gravity. Both
//! libraries describe the same bodies; IFToMM starts at β = −0.0620 rad, the IVP set at −0.06171389001427645, both at
//! rest. The seven outputs are the IVP set's variables; the angles Θ, Φ, Ω are those of the joints F, G, H.
//! Expected for the IVP set at 0.03 s: β 15.81077119629904, Θ −15.75637105984298, γ 0.04082224013073101,
//! Φ −0.5347301163226948, δ 0.5244099658805304, Ω 0.5347301163226948, ε 1.048080741042263 rad, β̇ 1139.920302151208
//! rad/s, good to about 1e-9 in positions and 5e-8 relative in rates. Expected of the other: T + V − τ (β − β₀) constant.

macro_rules! andrews {
    ($(#[$documentation:meta])* $name:ident, $beta:literal) => {
        linkwright::mechanism! {
            $(#[$documentation])*
            pub planar $name {
                body crank    { mass [kg] = 0.04325; inertia [kg*m^2] = 2.194e-6; center [m] = (0.00092, 0);
                                point f [m] = (0.007, 0); }
                body link     { mass [kg] = 0.00365; inertia [kg*m^2] = 4.410e-7; center [m] = (-0.0115, 0);
                                point e [m] = (-0.028, 0); }
                body triangle { mass [kg] = 0.02373; inertia [kg*m^2] = 5.255e-6; center [m] = (0.01043, -0.01874);
                                point d [m] = (0.02, -0.018); point e [m] = (0, -0.035); }
                body left     { mass [kg] = 0.00706; inertia [kg*m^2] = 5.667e-7; center [m] = (0, 0.01421);
                                point g [m] = (0, 0.02); }
                body upper    { mass [kg] = 0.0705; inertia [kg*m^2] = 1.169e-5; center [m] = (0.02308, 0.00916);
                                point g [m] = (0.04, 0); }
                body right    { mass [kg] = 0.00706; inertia [kg*m^2] = 5.667e-7; center [m] = (-0.01421, 0);
                                point h [m] = (-0.02, 0); }
                body lower    { mass [kg] = 0.05498; inertia [kg*m^2] = 1.912e-5; center [m] = (-0.00449, -0.01228);
                                point h [m] = (0, -0.04); }

                joint o:  revolute(ground(0, 0) [m], crank.origin);
                joint f:  revolute(crank.f, link.origin);
                joint b:  revolute(ground(-0.03635, 0.03273) [m], triangle.origin);
                joint a1: revolute(ground(-0.06934, -0.00227) [m], upper.origin);
                joint a2: revolute(ground(-0.06934, -0.00227) [m], lower.origin);
                joint g:  revolute(upper.g, left.g);
                joint h:  revolute(lower.h, right.h);
                joint e1: revolute(link.e, left.origin);
                joint e2: revolute(link.e, right.origin);
                joint e3: revolute(link.e, triangle.e);

                spring squeezer: spring(triangle.d, ground(0.014, 0.072) [m],
                                        stiffness = 4530 [N/m], length = 0.07785 [m]);
                torque motor: torque(o) = 0.033 [N*m];

                start  { o.angle [rad] = $beta; o.rate [rad/s] = 0;
                         f.angle [rad] ~ 0; triangle.angle [rad] ~ 0.455; g.angle [rad] ~ 0.223;
                         upper.angle [rad] ~ 0.487; h.angle [rad] ~ -0.223; lower.angle [rad] ~ 1.231; }
                options { emit = (penalty, projection, null_space); }
                expect { degrees_of_freedom = 1; }
                output beta [rad] = o.angle;
                output theta [rad] = f.angle;
                output gamma [rad] = triangle.angle;
                output phi [rad] = g.angle;
                output delta [rad] = upper.angle;
                output omega [rad] = h.angle;
                output epsilon [rad] = lower.angle;
            }
        }
    };
}

andrews! {
    /// Andrews' squeezing mechanism from the start of the IVP test set.
    ///
    /// At 0.03 s the crank stands at 15.81077119629904 rad and turns at 1139.920302151208 rad/s.
    Andrews, -0.0617138900142764496358948458001
}

andrews! {
    /// Andrews' squeezing mechanism from the start of the IFToMM library (A03).
    ///
    /// T + V − τ (β − β₀) stays constant over its 0.05 s.
    AndrewsIftomm, -0.0620
}
