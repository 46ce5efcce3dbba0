// Cycles and the sweep by any stepper with dense output: what the two Rosenbrock players share.
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include "slider.h"

// A stepper has a constructor of model, start and tolerance, and:
//   double step()                                one accepted step; the time before it; throws when no step succeeds
//   double time() const, const State &state()    where it is
//   void at(double time, State &)                the state at a time within the last step
using State = std::array<double, 3>;

struct Cycle {
    bool closed;
    double peak, duration;
    State end;
};

template <class Stepper, class Sign>
static double bisect(Stepper &stepper, State &work, double low, double high, Sign positive)
{
    stepper.at(low, work);
    const bool sign = positive(work);
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        stepper.at(middle, work);
        (positive(work) == sign ? low : high) = middle;
    }
    stepper.at(high, work);
    return high;
}

// From a start to the next upward crossing of V = V_l, or until the state is quiet or the steps are used up.
template <class Stepper>
static Cycle next_return(const slider &model, const State &start, double tolerance, long most_steps)
{
    Stepper stepper(model, start, tolerance);
    State work, rate;
    Cycle found{false, -INFINITY, 0, start};
    bool below = start[0] < 0;
    slider_rate(&model, start.data(), rate.data());
    double slope = rate[0];
    for (long step = 0; step < most_steps; step++) {
        double from;
        try {
            from = stepper.step();
        } catch (const std::exception &) {
            return found;
        }
        const double to = stepper.time();
        const State &state = stepper.state();
        if (!std::isfinite(state[0]))
            return found;
        slider_rate(&model, state.data(), rate.data());
        if (state[0] > 0 && rate[0] < 0 && slope > 0) {
            bisect(stepper, work, from, to, [&](const State &at) {
                State there;
                slider_rate(&model, at.data(), there.data());
                return there[0] > 0;
            });
            found.peak = std::max(found.peak, work[0]);
        }
        slope = rate[0];
        if (state[0] > 0 && below) {
            found.duration = bisect(stepper, work, from, to, [](const State &at) { return at[0] > 0; });
            found.closed = true;
            found.end = work;
            return found;
        }
        below = state[0] < 0;
        found.end = state;
        if (std::abs(state[0]) + std::abs(state[1]) + std::abs(state[2]) < 1e-9)
            return found;
    }
    return found;
}

template <class Stepper> static void cycles(const char *folder, const char *method, const char *options)
{
    FILE *file = open_input(folder, "cycles.txt");
    slider model;
    double given[5];
    while (read_slider(file, &model)) {
        for (double &value : given)
            if (fscanf(file, "%lf", &value) != 1)
                exit(1);
        const State start{given[0], given[1], given[2]};
        for (int halves = FIRST_HALF_DECADE; halves <= LAST_HALF_DECADE; halves++) {
            const double tolerance = tolerance_of(halves);
            double best = INFINITY;
            Cycle found;
            for (int repetition = 0; repetition < 3; repetition++) {
                const double began = cpu_seconds();
                found = next_return<Stepper>(model, start, tolerance, 200000);
                best = std::min(best, cpu_seconds() - began);
                if (best > 0.2)
                    break;
            }
            char work[96];
            snprintf(work, sizeof work, "cycles-%s", model.name);
            const double error = std::max(std::abs(found.peak - given[3]), std::abs(found.duration / given[4] - 1));
            print_row(work, method, options, tolerance, 1, best, found.closed ? error : -1, !found.closed);
        }
    }
}

// Follows returns until two peaks agree to 1e-4 (a cycle) or are below 1e-3 (rest); 2000 returns at most. A slow decay changes
// its peaks by a constant share, so that agreement is relative to the peak.
template <class Stepper> static bool settle(const slider &model, double tolerance, bool &cycle, double &peak)
{
    State state{-std::log(10.0), std::log(10.0), -(1 - model.beta) * std::log(10.0)};
    double last = INFINITY, first = -std::log(10.0);
    for (int count = 0; count < 2000; count++) {
        const Cycle found = next_return<Stepper>(model, state, tolerance, 100000);
        first = std::max(first, found.peak);
        if (!found.closed) {
            cycle = false;
            peak = first;
            return std::abs(found.end[0]) < 1e-6;
        }
        if (count > 1 && found.peak < 1e-3) {
            cycle = false;
            peak = first;
            return true;
        }
        if (count > 1 && std::abs(found.peak - last) < 1e-4 * std::min(1.0, found.peak)) {
            cycle = true;
            peak = found.peak;
            return true;
        }
        last = found.peak;
        state = found.end;
    }
    return false;
}

template <class Stepper> static void sweep(const char *folder, const char *method, const char *options)
{
    for (int halves = 4; halves <= 12; halves++) {
        const double tolerance = tolerance_of(halves);
        FILE *file = open_input(folder, "sweep.txt");
        slider model;
        double expected_cycle, expected_peak, seconds = 0, error = 0;
        long runs = 0, wrong = 0;
        while (read_slider(file, &model) && fscanf(file, "%lf %lf", &expected_cycle, &expected_peak) == 2) {
            bool cycle = false;
            double peak = 0;
            const double began = cpu_seconds();
            const bool settled = settle<Stepper>(model, tolerance, cycle, peak);
            seconds += cpu_seconds() - began;
            runs++;
            const double missed = std::abs(std::expm1(peak - expected_peak));
            if (!settled || cycle != (expected_cycle == 1) || missed > 1e-2)
                wrong++;
            else
                error = std::max(error, missed);
        }
        print_row("sweep", method, options, tolerance, runs, seconds, error, wrong);
        fclose(file);
    }
}

template <class Stepper>
static void play(char **words, const char *method, const char *options)
{
    if (strcmp(words[1], "sweep") == 0)
        sweep<Stepper>(words[2], method, options);
    else
        cycles<Stepper>(words[2], method, options);
}
