"""The decks of spacetime parts. Used by make.py."""
import spacetime_cracks
import spacetime_fibres
import spacetime_intensity
import spacetime_penny
import spacetime_waves

VALIDATION = {**spacetime_cracks.CASES, **spacetime_intensity.CASES}   # published figures
CASES = {**spacetime_waves.CASES, **spacetime_fibres.CASES, **VALIDATION}
EXAMPLES = {**spacetime_waves.EXAMPLES, **spacetime_cracks.EXAMPLES, **spacetime_penny.EXAMPLES}   # tests that are shown, too
LARGE = {**spacetime_cracks.LARGE, **spacetime_intensity.LARGE, **spacetime_penny.LARGE}   # on demand only
