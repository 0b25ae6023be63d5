"""The same mission many times: what does a parameter change?

    ./mlab python python/examples/compare_speeds.py
"""

import mlab

table = mlab.batch("missions/patrol/patrol.mdl", runs=20, set={"base_velocity": [0.5, 1, 2]})
for speed in (0.5, 1, 2):
    runs = table.where(table["base_velocity"] == speed)
    print(f"{speed} m/s: {runs['duration_s'].mean():.0f} s, {runs['distance_m'].mean():.0f} m")

for combination in table.combinations:
    print(f"{combination.set}: {combination.successes} of {combination.runs}, between {combination.low:.2f} and {combination.high:.2f}")

# It prints:
#     0.5 m/s: 1738 s, 1087 m
#     1 m/s: 870 s, 1087 m
#     2 m/s: 435 s, 1088 m
#     {'base_velocity': '0.5'}: 20 of 20, between 0.83 and 1.00
#     {'base_velocity': '1'}: 20 of 20, between 0.83 and 1.00
#     {'base_velocity': '2'}: 20 of 20, between 0.83 and 1.00
