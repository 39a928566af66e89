"""Each renderer in a process of its own, as they do not get along in one: that of lichtraum is this one's child's child."""

import importlib
import multiprocessing


def serve(pipe, module, name, arguments):
    """In the renderer's process: answers (method, arguments) with (True, result) or (False, message)."""
    try:
        renderer = getattr(importlib.import_module(module), name)(*arguments)
        pipe.send((True, None))
    except Exception as error:  # whatever an installation lacks
        pipe.send((False, f"{type(error).__name__}: {error}"))
        return
    while (call := pipe.recv()) is not None:
        method, arguments = call
        try:
            pipe.send((True, getattr(renderer, method)(*arguments)))
        except Exception as error:
            pipe.send((False, f"{type(error).__name__}: {error}"))


class Renderer:
    """open(scene, job) prepares; render(seed) returns seconds and (height, width, 3) of radiance, the topmost row first."""

    def __init__(self, label, module, name, *arguments):
        self.label = label
        context = multiprocessing.get_context("spawn")
        self.pipe, other = context.Pipe()
        self.process = context.Process(target=serve, args=(other, f"{__package__}.{module}", name, arguments), daemon=True)
        self.process.start()
        other.close()
        self.answer()

    def answer(self):
        try:
            is_good, result = self.pipe.recv()
        except EOFError:
            self.process.join()
            is_good, result = False, f"the process ended with {self.process.exitcode}"
        if not is_good:
            raise RuntimeError(f"{self.label}: {result}")
        return result

    def call(self, method, *arguments):
        self.pipe.send((method, arguments))
        return self.answer()

    def open(self, scene, job):
        self.call("open", scene, job)

    def render(self, seed):
        return self.call("render", seed)

    def close(self):
        self.pipe.send(None)
        self.process.join()
