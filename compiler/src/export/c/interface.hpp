// The mechanism `@name` in C++11, written out by Linkwright @version: @m.h as a class, without exceptions and without allocation.
#ifndef @M_HPP
#define @M_HPP

#include "@m.h"

namespace linkwright {

class @class {
public:
    @?parameters using Parameters = @m_parameters_t;
    @?inputs using Inputs = @m_inputs_t;
    @?outputs using Outputs = @m_outputs_t;
    using State = @m_state_t;
    using Status = @m_status_t;
    using Tick = @m_tick_t;
    using Saved = @m_saved_t;
    using Number = @real;

    /// At the start and time zero.
    @class() noexcept { (void)@m_init(&plant_@cppnull); }

    @?parameters Status init(const Parameters &parameters) noexcept { return @m_init(&plant_, &parameters); }
    @?parameters Status set_parameters(const Parameters &parameters) noexcept { return @m_set_parameters(&plant_, &parameters); }
    @?parameters const Parameters &parameters() const noexcept { return plant_.model.parameters; }
    @?parameters
    Status set_state(Number time, const State &state) noexcept { return @m_set_state(&plant_, time, &state); }
    const State &state() const noexcept { return plant_.state; }
    Number time() const noexcept { return plant_.time[0]; }

    Status step_rk4(@cppinputs Number h, Tick *tick = nullptr) noexcept
    {
        return @m_step_rk4(&plant_,@cppu h, tick);
    }
    Status step_semi_implicit_euler(@cppinputs Number h, Tick *tick = nullptr) noexcept
    {
        return @m_step_semi_implicit_euler(&plant_,@cppu h, tick);
    }
    @?corrects Status step_rk4_corrected(@cppinputs Number h, Tick *tick = nullptr) noexcept
    @?corrects {
    @?corrects     return @m_step_rk4_corrected(&plant_,@cppu h, tick);
    @?corrects }
    @?corrects Status step_semi_implicit_euler_corrected(@cppinputs Number h, Tick *tick = nullptr) noexcept
    @?corrects {
    @?corrects     return @m_step_semi_implicit_euler_corrected(&plant_,@cppu h, tick);
    @?corrects }

    @?corrects Status assemble() noexcept { return @m_assemble(&plant_); }
    @?outputs Status read_outputs(@cppinputs Outputs &outputs) noexcept { return @m_read_outputs(&plant_,@cppu &outputs); }
    Status save(Saved &saved) const noexcept { return @m_save(&plant_, &saved); }
    Status restore(const Saved &saved) noexcept { return @m_restore(&plant_, &saved, sizeof(saved)); }

    /// For the functions of @m.h.
    const @m_model_t &model() const noexcept { return plant_.model; }
    @m_t &plant() noexcept { return plant_; }

    static const State &start() noexcept { return @m_start; }
    static const char *text(Status status) noexcept { return @m_status_text(status); }

private:
    @m_t plant_;
};

} // namespace linkwright

#endif
