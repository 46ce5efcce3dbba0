// A static Rosenbrock method: the coefficients, step control and dense output of boost's rosenbrock4, on arrays of three numbers.
//
// boost keeps states and matrices in vectors of any length. This program shows what its method costs without them.
#include <stdexcept>

#include "slider_runs.hpp"

// Elimination with row pivots of a 3 x 3 matrix, kept for several right-hand sides.
struct Factors {
    double m[3][3];
    int row[3];

    void factorize()
    {
        for (int i = 0; i < 3; i++) {
            int pivot = i;
            for (int k = i + 1; k < 3; k++)
                if (std::abs(m[k][i]) > std::abs(m[pivot][i]))
                    pivot = k;
            row[i] = pivot;
            if (pivot != i)
                std::swap(m[i], m[pivot]);
            const double inverse = 1 / m[i][i];
            for (int k = i + 1; k < 3; k++) {
                m[k][i] *= inverse;
                for (int j = i + 1; j < 3; j++)
                    m[k][j] -= m[k][i] * m[i][j];
            }
        }
    }

    void solve(State &b) const
    {
        for (int i = 0; i < 3; i++)
            std::swap(b[i], b[row[i]]);
        b[1] -= m[1][0] * b[0];
        b[2] -= m[2][0] * b[0] + m[2][1] * b[1];
        b[2] /= m[2][2];
        b[1] = (b[1] - m[1][2] * b[2]) / m[1][1];
        b[0] = (b[0] - m[0][1] * b[1] - m[0][2] * b[2]) / m[0][0];
    }
};

class Static {
    const slider &model;
    double tolerance, now = 0, before = 0, size;
    State current, old, g1, g2, g3, g4, g5, cont3, cont4, error;
    bool is_first = true, was_rejected = false;
    double last_error = 0, last_size = 0;

    // The step of this size from the current state, as boost's rosenbrock4 makes it for an autonomous system.
    State attempt()
    {
        State x, rate, next;
        Factors w;
        const double h = size;
        slider_rate(&model, current.data(), rate.data());
        slider_jacobian(&model, current.data(), w.m);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                w.m[i][j] = (i == j ? 1 / 0.25 / h : 0) - w.m[i][j];
        w.factorize();
        g1 = rate;
        w.solve(g1);
        for (int i = 0; i < 3; i++)
            x[i] = current[i] + 0.1544000000000000e+01 * g1[i];
        slider_rate(&model, x.data(), rate.data());
        for (int i = 0; i < 3; i++)
            g2[i] = rate[i] - 0.5668800000000000e+01 * g1[i] / h;
        w.solve(g2);
        for (int i = 0; i < 3; i++)
            x[i] = current[i] + 0.9466785280815826e+00 * g1[i] + 0.2557011698983284e+00 * g2[i];
        slider_rate(&model, x.data(), rate.data());
        for (int i = 0; i < 3; i++)
            g3[i] = rate[i] + (-0.2430093356833875e+01 * g1[i] - 0.2063599157091915e+00 * g2[i]) / h;
        w.solve(g3);
        for (int i = 0; i < 3; i++)
            x[i] = current[i] + 0.3314825187068521e+01 * g1[i] + 0.2896124015972201e+01 * g2[i] +
                   0.9986419139977817e+00 * g3[i];
        slider_rate(&model, x.data(), rate.data());
        for (int i = 0; i < 3; i++)
            g4[i] = rate[i] + (-0.1073529058151375e+00 * g1[i] - 0.9594562251023355e+01 * g2[i] -
                               0.2047028614809616e+02 * g3[i]) / h;
        w.solve(g4);
        for (int i = 0; i < 3; i++)
            x[i] = current[i] + 0.1221224509226641e+01 * g1[i] + 0.6019134481288629e+01 * g2[i] +
                   0.1253708332932087e+02 * g3[i] - 0.6878860361058950e+00 * g4[i];
        slider_rate(&model, x.data(), rate.data());
        for (int i = 0; i < 3; i++)
            g5[i] = rate[i] + (0.7496443313967647e+01 * g1[i] - 0.1024680431464352e+02 * g2[i] -
                               0.3399990352819905e+02 * g3[i] + 0.1170890893206160e+02 * g4[i]) / h;
        w.solve(g5);
        for (int i = 0; i < 3; i++)
            x[i] += g5[i];
        slider_rate(&model, x.data(), rate.data());
        for (int i = 0; i < 3; i++)
            error[i] = rate[i] + (0.8083246795921522e+01 * g1[i] - 0.7981132988064893e+01 * g2[i] -
                                  0.3152159432874371e+02 * g3[i] + 0.1631930543123136e+02 * g4[i] -
                                  0.6058818238834054e+01 * g5[i]) / h;
        w.solve(error);
        for (int i = 0; i < 3; i++)
            next[i] = x[i] + error[i];
        return next;
    }

    double norm(const State &next) const
    {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            const double scale = tolerance + tolerance * std::max(std::abs(current[i]), std::abs(next[i]));
            sum += error[i] * error[i] / scale / scale;
        }
        return std::sqrt(sum / 3);
    }

    // Whether a step with this error is accepted; either way the size of the next one.
    bool control(double found)
    {
        const auto bounded = [](double factor) { return std::max(1.0 / 6, std::min(5.0, factor)); };
        double factor = bounded(std::sqrt(std::sqrt(found)) / 0.9);
        if (!(found <= 1)) {
            size /= factor;
            was_rejected = true;
            return false;
        }
        if (!is_first)
            factor = std::max(factor, bounded(last_size / size * std::sqrt(std::sqrt(found * found / last_error)) / 0.9));
        is_first = false;
        last_size = size;
        last_error = std::max(0.01, found);
        now += size;
        size = was_rejected ? std::min(size / factor, size) : size / factor;
        was_rejected = false;
        return true;
    }

  public:
    Static(const slider &model, const State &start, double tolerance)
        : model(model), tolerance(tolerance), size(1e-6 * std::min(1.0, model.eta)), current(start)
    {
    }

    double step()
    {
        before = now;
        for (int attempts = 0; attempts < 500; attempts++) {
            const State next = attempt();
            if (!control(norm(next)))
                continue;
            for (int i = 0; i < 3; i++) {
                cont3[i] = 0.1012623508344586e+02 * g1[i] - 0.7487995877610167e+01 * g2[i] -
                           0.3480091861555747e+02 * g3[i] - 0.7992771707568823e+01 * g4[i] +
                           0.1025137723295662e+01 * g5[i];
                cont4[i] = -0.6762803392801253e+00 * g1[i] + 0.6087714651680015e+01 * g2[i] +
                           0.1643084320892478e+02 * g3[i] + 0.2476722511418386e+02 * g4[i] -
                           0.6594389125716872e+01 * g5[i];
            }
            old = current;
            current = next;
            return before;
        }
        throw std::runtime_error("500 steps in turn failed");
    }

    double time() const { return now; }

    const State &state() const { return current; }

    void at(double time, State &there) const
    {
        const double s = (time - before) / (now - before), rest = 1 - s;
        for (int i = 0; i < 3; i++)
            there[i] = old[i] * rest + s * (current[i] + rest * (cont3[i] + s * cont4[i]));
    }
};

int main(int count, char **words)
{
    if (count < 3) {
        printf("static rosenbrock4 (g++ %s)\n", __VERSION__);
        return 0;
    }
    play<Static>(words, "static-rosenbrock4", "dense~output;analytic~Jacobian;3x3~arrays");
    return 0;
}
