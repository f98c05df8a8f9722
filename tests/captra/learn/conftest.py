import torch

# Networks this small gain nothing from threads, which wait actively for each other where the machine is busy.
torch.set_num_threads(1)
