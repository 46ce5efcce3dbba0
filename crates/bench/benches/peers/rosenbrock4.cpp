// boost.odeint: stick-slip cycles and the sweep by rosenbrock4 with dense output and the analytic Jacobian.
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>

#include "slider_runs.hpp"

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

class Boost {
    using Dense = odeint::rosenbrock4_dense_output<odeint::rosenbrock4_controller<odeint::rosenbrock4<double>>>;

    std::pair<Rate, Jacobian> system;
    Dense dense;
    Vector work;
    State now;

  public:
    Boost(const slider &model, const State &start, double tolerance)
        : system(Rate{&model}, Jacobian{&model}),
          dense(odeint::make_dense_output(tolerance, tolerance, odeint::rosenbrock4<double>())), work(3), now(start)
    {
        std::copy(start.begin(), start.end(), work.begin());
        dense.initialize(work, 0.0, 1e-6 * std::min(1.0, model.eta));
    }

    double step()
    {
        const double from = dense.do_step(system).first;
        std::copy(dense.current_state().begin(), dense.current_state().end(), now.begin());
        return from;
    }

    double time() const { return dense.current_time(); }

    const State &state() const { return now; }

    void at(double time, State &there)
    {
        dense.calc_state(time, work);
        std::copy(work.begin(), work.end(), there.begin());
    }
};

int main(int count, char **words)
{
    if (count < 3) {
        printf("boost %d.%d\n", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000);
        return 0;
    }
    play<Boost>(words, "boost-rosenbrock4", "dense~output;analytic~Jacobian;ublas~vectors");
    return 0;
}
