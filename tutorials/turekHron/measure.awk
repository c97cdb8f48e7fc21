# Mean, amplitude and frequency of each column of a history (time, then one quantity a
# column, named by its first line), and by how much they differ from those before:
#
#   awk -v periods=5 -v key=3 -f measure.awk HISTORY    a swing, of PERIODS periods of column KEY
#   awk -f measure.awk HISTORY                          a steady state
#
# Prints first "window FROM TO PERIODS", then per quantity "NAME MEAN AMPLITUDE FREQUENCY
# CHANGE". A swing: mean and amplitude are half the sum and half the difference of each
# period's extrema, averaged over the last PERIODS periods; the frequency is that of the
# largest of the first six Fourier coefficients; CHANGE [%] is the largest change of mean
# and amplitude from the PERIODS periods before, relative to the amplitude. A steady
# state: the mean of the last tenth of the time, and its change [%] from the tenth before.

NR == 1 { for (c = 2; c <= NF; c++) name[c] = $c; columns = NF; next }
{ n++; for (c = 1; c <= NF; c++) x[n, c] = $c }

function abs(v) { return v < 0 ? -v : v }

# Times at which column c rises through the middle of its last extrema; a swing below a
# tenth of the amplitude is none
function findRises(c,   i, low, high, middle, armed) {
    low = 1e300; high = -1e300
    for (i = n; i > n - n/5; i--) {
        if (x[i, c] < low) low = x[i, c]
        if (x[i, c] > high) high = x[i, c]
    }
    middle = (low + high)/2
    for (i = 2; i <= n; i++) {
        if (x[i - 1, c] < middle - 0.05*(high - low)) armed = 1
        if (armed && x[i - 1, c] < middle && x[i, c] >= middle) {
            rise[++rises] = i
            riseTime[rises] = x[i - 1, 1] + (middle - x[i - 1, c])/(x[i, c] - x[i - 1, c])*(x[i, 1] - x[i - 1, 1])
            armed = 0
        }
    }
}

# mean and amplitude of column c over the periods from rise a to rise b
function measure(c, a, b,   k, i, low, high) {
    mean = amplitude = 0
    for (k = a; k < b; k++) {
        low = 1e300; high = -1e300
        for (i = rise[k]; i < rise[k + 1]; i++) {
            if (x[i, c] < low) low = x[i, c]
            if (x[i, c] > high) high = x[i, c]
        }
        mean += (high + low)/2/(b - a)
        amplitude += (high - low)/2/(b - a)
    }
}

# Number of swings of column c in a period
function harmonic(c, a, b,   k, i, phase, re, im, largest, best) {
    largest = -1
    for (k = 1; k <= 6; k++) {
        re = im = 0
        for (i = rise[a]; i < rise[b]; i++) {
            phase = 8*atan2(1, 1)*k*(b - a)*(i - rise[a])/(rise[b] - rise[a])
            re += x[i, c]*cos(phase); im += x[i, c]*sin(phase)
        }
        if (re*re + im*im > largest) { largest = re*re + im*im; best = k }
    }
    return best
}

function swing(   a, b, c, before, swingBefore) {
    findRises(key)
    if (periods > int((rises - 1)/2)) periods = int((rises - 1)/2)
    if (periods < 1) { print "window 0 0 0"; return }
    b = rises; a = b - periods
    print "window", riseTime[a], riseTime[b], periods
    for (c = 2; c <= columns; c++) {
        measure(c, a - periods, a)
        before = mean; swingBefore = amplitude
        measure(c, a, b)
        print name[c], mean, amplitude, harmonic(c, a, b)*periods/(riseTime[b] - riseTime[a]),
            100*(abs(mean - before) > abs(amplitude - swingBefore) ? abs(mean - before) : abs(amplitude - swingBefore))/amplitude
    }
}

# mean of column c over the rows with from < time <= to
function average(c, from, to,   i, sum, rows) {
    for (i = 1; i <= n; i++) if (x[i, 1] > from && x[i, 1] <= to) { sum += x[i, c]; rows++ }
    return rows ? sum/rows : x[n, c]
}

function steady(   c, end, now) {
    end = x[n, 1]
    print "window", 0.9*end, end, 1
    for (c = 2; c <= columns; c++) {
        now = average(c, 0.9*end, end)
        print name[c], now, 0, 0, 100*abs(now/average(c, 0.8*end, 0.9*end) - 1)
    }
}

END { if (periods) swing(); else steady() }
