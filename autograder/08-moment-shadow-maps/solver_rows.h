// Rows for the two solvers, and how far their answers are off.
#pragma once

#include "moment_checks.h"

namespace penumbra {

// Inputs of a solver. Truths are of moments(i) and t(i), which are rounded as the program sees
// them.
class SolverRows {
public:
    void add(const dvec4& moments, double t) {
        moments_.emplace_back(moments);
        t_.emplace_back(float(t));
    }
    dvec4 moments(int i) const { return moments_[std::size_t(i)]; }
    double t(int i) const { return t_[std::size_t(i)].x; }
    std::size_t size() const { return t_.size(); }

    Rows evaluate(const std::string& chunk, const std::string& expression) const;
    Rows blockers(const std::string& method) const;  // share and depth, from hamburgerBlockers() …

private:
    Rows moments_, t_;
};

extern const RowTolerance kThreePoints;
extern const std::string kShareCause;

// The worst row, in terms of what is allowed there.
double worstShare(const Rows& mine, const std::vector<Below>& truth,
                  const std::vector<double>& allowed);
double worstDepth(const Rows& mine, const std::vector<Below>& truth,
                  const std::vector<double>& allowed);
double mostOver(const Rows& mine, const std::vector<Below>& truth,
                const std::vector<double>& allowed);

// Moments without bias, so that their matrix is singular or, by rounding, not even that of any
// depths; and t anywhere, at the ends, at a depth.
SolverRows anyMoments(unsigned seed);
// Shares from 0 to 1, depths from -1 to t or 0 where there is no share. The runner has made sure
// that all are finite.
void expectShares(const Rows& mine, const SolverRows& rows);

}  // namespace penumbra
