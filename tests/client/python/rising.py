"""What every progress keeps to."""


def assert_rises(case, values):
    """Fails unless the values are parts of a whole that never fall, and end with 1."""
    case.assertTrue(values)
    case.assertEqual(list(values), sorted(values))
    case.assertGreaterEqual(values[0], 0)
    case.assertEqual(values[-1], 1)
