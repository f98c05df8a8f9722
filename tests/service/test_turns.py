import threading
import time
from concurrent.futures import ThreadPoolExecutor

from service.turns import Turns

AT_ONCE, THREADS, ROUNDS = 3, 12, 40


def test_so_many_are_inside_at_once_and_everybody_gets_the_same_number_of_turns() -> None:
    turns, lock, stop = Turns(AT_ONCE), threading.Lock(), threading.Event()
    inside, most, taken = 0, 0, [0] * THREADS
    started = threading.Barrier(THREADS)

    def work(number: int) -> None:
        nonlocal inside, most
        started.wait(20)
        while not stop.is_set():
            with turns:
                with lock:
                    inside += 1
                    most = max(most, inside)
                    taken[number] += 1
                    if taken[number] >= ROUNDS:
                        stop.set()
                time.sleep(0.0005)
                with lock:
                    inside -= 1

    with ThreadPoolExecutor(THREADS) as pool:
        for done in [pool.submit(work, number) for number in range(THREADS)]:
            done.result()
    assert most == AT_ONCE
    assert min(taken) > ROUNDS / 2


def test_they_come_in_the_order_in_which_they_asked() -> None:
    turns, order, waiting = Turns(1), list[int](), list[threading.Thread]()
    with turns:
        for number in range(5):
            waiting.append(threading.Thread(target=lambda mine=number: take(turns, order, mine)))
            waiting[-1].start()
            while len(turns._waiting) <= number:
                time.sleep(0.001)
    for thread in waiting:
        thread.join()
    assert order == list(range(5))


def take(turns: Turns, order: list[int], number: int) -> None:
    with turns:
        order.append(number)


def test_an_error_inside_gives_the_turn_back() -> None:
    turns = Turns(1)
    for _ in range(2):
        try:
            with turns:
                raise ValueError
        except ValueError:
            pass
    with turns:
        pass
