from clients.hop import hops


def test_payloads_come_back() -> None:
    small, large = hops(5, (64, 2_000_000))
    assert (small.payload_bytes, large.payload_bytes) == (64, 2_000_000)
    assert min(small.round_trip.p50, large.round_trip.p50) > 0  # which one is slower depends on what else runs
