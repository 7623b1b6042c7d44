"""The random stream equals that of docs/team-programs.md."""
import pickle
import unittest

from autoref import RandomStream

_MODULUS = 2**64
_STEP = 0x9E3779B97F4A7C15


def _mix(x):
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9 % _MODULUS
    x = (x ^ (x >> 27)) * 0x94D049BB133111EB % _MODULUS
    return x ^ (x >> 31)


class RandomStreams(unittest.TestCase):
    """Numbers, seeds and the methods of random.Random."""

    def test_have_the_numbers_of_the_formula(self):
        for seed in (0, 7, _MODULUS - 1):
            stream = RandomStream(seed)
            for n in range(1, 50):
                number = _mix((_mix((seed + _STEP) % _MODULUS) + n * _STEP) % _MODULUS)
                self.assertEqual(stream.next_bits(), number)

    def test_are_uniform_between_0_and_1(self):
        stream = RandomStream(4)
        numbers = [stream.random() for _ in range(10000)]
        self.assertTrue(0 <= min(numbers) < max(numbers) < 1)
        self.assertAlmostEqual(sum(numbers) / 10000, 0.5, delta=0.01)

    def test_repeat_everything_with_the_same_seed(self):
        def draws(stream):
            return stream.choice(range(100)), stream.gauss(0, 1), stream.sample(range(9), 4)

        self.assertEqual(draws(RandomStream(5)), draws(RandomStream(5)))
        self.assertNotEqual(draws(RandomStream(5)), draws(RandomStream(6)))

    def test_have_as_many_bits_as_asked_for(self):
        stream = RandomStream(1)
        self.assertEqual({stream.getrandbits(3) for _ in range(200)}, set(range(8)))
        self.assertEqual(stream.getrandbits(0), 0)
        self.assertLess(max(stream.getrandbits(70) for _ in range(200)).bit_length(), 71)

    def test_continue_from_a_copy_of_their_state(self):
        stream = RandomStream(9)
        stream.next_bits()
        copy = pickle.loads(pickle.dumps(stream))
        self.assertEqual(copy.next_bits(), stream.next_bits())


if __name__ == "__main__":
    unittest.main()
