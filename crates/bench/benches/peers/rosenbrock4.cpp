// boost.odeint: stick-slip cycles and the sweep by rosenbrock4 with dense output and the analytic Jacobian.
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>

#include "slider.h"

namespace odeint = boost::numeric::odeint;
using Vector = boost::numeric::ublas::vector<double>;
using Matrix = boost::numeric::ublas::matrix<double>;

struct Rate {
    const slider *model;
    void operator()(const Vector &state, Vector &rate, double) const { slider_rate(model, &state[0], &rate[0]); }
};

struct Jacobian {
    const slider *model;
    void operator()(const Vector &state, Matrix &out, const double &, Vector &in_time) const
    {
        double entries[3][3];
        slider_jacobian(model, &state[0], entries);
        for (int i = 0; i < 3; i++) {
            in_time[i] = 0;
            for (int j = 0; j < 3; j++)
                out(i, j) = entries[i][j];
        }
    }
};

using Stepper = odeint::rosenbrock4_dense_output<odeint::rosenbrock4_controller<odeint::rosenbrock4<double>>>;

struct Lap {
    bool closed;
    double peak, duration;
    Vector end;
};

template <class Sign> static double bisect(Stepper &stepper, Vector &work, double low, double high, Sign positive)
{
    stepper.calc_state(low, work);
    const bool sign = positive(work);
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        stepper.calc_state(middle, work);
        (positive(work) == sign ? low : high) = middle;
    }
    stepper.calc_state(high, work);
    return high;
}

// From a start to the next upward passage of V = V_l, or until the state is quiet or the steps are used up.
static Lap lap(const slider &model, const Vector &start, double tolerance, long most_steps)
{
    const auto system = std::make_pair(Rate{&model}, Jacobian{&model});
    auto stepper = odeint::make_dense_output(tolerance, tolerance, odeint::rosenbrock4<double>());
    stepper.initialize(start, 0.0, 1e-6 * std::min(1.0, model.eta));
    Vector work(3), rate(3);
    Lap found{false, -INFINITY, 0, start};
    bool below = start[0] < 0;
    slider_rate(&model, &start[0], &rate[0]);
    double slope = rate[0];
    for (long step = 0; step < most_steps; step++) {
        double from, to;
        try {
            std::tie(from, to) = stepper.do_step(system);
        } catch (const std::exception &) {
            return found;
        }
        const Vector &state = stepper.current_state();
        if (!std::isfinite(state[0]))
            return found;
        slider_rate(&model, &state[0], &rate[0]);
        if (state[0] > 0 && rate[0] < 0 && slope > 0) {
            bisect(stepper, work, from, to, [&](const Vector &at) {
                Vector there(3);
                slider_rate(&model, &at[0], &there[0]);
                return there[0] > 0;
            });
            found.peak = std::max(found.peak, work[0]);
        }
        slope = rate[0];
        if (state[0] > 0 && below) {
            found.duration = bisect(stepper, work, from, to, [](const Vector &at) { return at[0] > 0; });
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

static void cycles(const char *folder)
{
    FILE *file = open_input(folder, "cycles.txt");
    slider model;
    double given[5];
    while (read_slider(file, &model)) {
        for (double &value : given)
            if (fscanf(file, "%lf", &value) != 1)
                exit(1);
        Vector start(3);
        std::copy(given, given + 3, start.begin());
        for (int exponent = 3; exponent <= 11; exponent++) {
            const double tolerance = std::pow(10, -exponent);
            double best = INFINITY;
            Lap found;
            for (int repetition = 0; repetition < 3; repetition++) {
                const double began = cpu_seconds();
                found = lap(model, start, tolerance, 200000);
                best = std::min(best, cpu_seconds() - began);
                if (best > 0.2)
                    break;
            }
            char work[96];
            snprintf(work, sizeof work, "cycles-%s", model.name);
            const double error = std::max(std::abs(found.peak - given[3]), std::abs(found.duration / given[4] - 1));
            print_row(work, "boost-rosenbrock4", tolerance, 1, best, found.closed ? error : -1, !found.closed);
        }
    }
}

// Follows laps until two peaks agree to 1e-4 (a cycle) or are below 1e-3 (rest); 2000 laps at most. A slow decay changes its
// peaks by a constant share, so that agreement is relative to the peak.
static bool settle(const slider &model, double tolerance, bool &cycle, double &peak)
{
    Vector state(3);
    state[0] = -std::log(10.0), state[1] = -state[0], state[2] = (1 - model.beta) * state[0];
    double last = INFINITY, first = -std::log(10.0);
    for (int count = 0; count < 2000; count++) {
        const Lap found = lap(model, state, tolerance, 100000);
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

static void sweep(const char *folder)
{
    for (const double tolerance : {1e-4, 1e-5, 1e-6}) {
        FILE *file = open_input(folder, "sweep.txt");
        slider model;
        double expected_cycle, expected_peak, seconds = 0, error = 0;
        long runs = 0, wrong = 0;
        while (read_slider(file, &model) && fscanf(file, "%lf %lf", &expected_cycle, &expected_peak) == 2) {
            bool cycle = false;
            double peak = 0;
            const double began = cpu_seconds();
            const bool settled = settle(model, tolerance, cycle, peak);
            seconds += cpu_seconds() - began;
            runs++;
            const double missed = std::abs(std::expm1(peak - expected_peak));
            if (!settled || cycle != (expected_cycle == 1) || missed > 1e-2)
                wrong++;
            else
                error = std::max(error, missed);
        }
        print_row("sweep", "boost-rosenbrock4", tolerance, runs, seconds, error, wrong);
        fclose(file);
    }
}

int main(int count, char **words)
{
    if (count < 3) {
        printf("boost %d.%d\n", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000);
        return 0;
    }
    if (strcmp(words[1], "sweep") == 0)
        sweep(words[2]);
    else
        cycles(words[2]);
    return 0;
}
