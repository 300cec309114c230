# SPDX-FileCopyrightText: 2026 The RaDiVe authors
# SPDX-License-Identifier: BSD-3-Clause
"""A folder of results that changes in one step; as radive/util/output_folder.h, in Python."""

import contextlib
import ctypes
import errno
import fcntl
import os
import pathlib
import shutil

from report.run_files import FileError

AT_FDCWD = -100
RENAME_EXCHANGE = 2
NEW, READY, MOVING = ".radive-new", ".radive-ready", ".radive-moving"


@contextlib.contextmanager
def replaced(folder, own):
    """The folder to write the new content into; at the end it takes the place of the earlier one.

    `own` are the names in `folder` that are replaced; others stay. After an exception the earlier
    content is there, whole, and nothing of the new one. docs/reliability.md says how.
    """
    made = not folder.exists()
    folder.mkdir(parents=True, exist_ok=True)
    folder = folder.resolve()
    with contextlib.ExitStack() as locks:
        lock(folder, locks)
        staged = None
        try:
            recover(folder, own)
            staged = stage(folder, own)
            yield staged
            publish(staged, folder, own, locks)
        except BaseException:
            if staged:
                shutil.rmtree(staged, ignore_errors=True)
            if made:
                with contextlib.suppress(OSError):
                    folder.rmdir()
            raise


def write_file(path, data):
    """Text or bytes. An error names the file, which that of a full disk does not by itself."""
    try:
        path.write_bytes(data if isinstance(data, bytes) else data.encode("utf-8"))
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror}") from error


def lock(folder, locks):
    while True:
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        locks.callback(os.close, handle)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise FileError(f"{folder}: another program is writing into this folder") from None
        except OSError:
            return  # a file system that cannot lock folders
        if os.path.samestat(os.fstat(handle), os.stat(folder)):
            return


def beside(folder):
    return folder.parent / f".{folder.name}.radive"


def recover(folder, own):
    """Clears away what a killed program has left, and finishes what it had begun to replace."""
    if beside(folder).is_dir():
        remove_earlier(folder, own)
    shutil.rmtree(folder / NEW, ignore_errors=True)
    replace_each(folder, own)


def stage(folder, own):
    strangers = [path for path in folder.iterdir() if path.name not in own]
    can_be_exchanged = (
        folder.name
        and folder not in [pathlib.Path.cwd(), *pathlib.Path.cwd().parents]
        and not os.path.ismount(folder)
        and os.access(folder.parent, os.W_OK)
        and not any(path.is_dir() and not path.is_symlink() for path in strangers)
    )
    if can_be_exchanged:
        staged = beside(folder)
        try:
            staged.mkdir()
            earlier = folder.stat()
            os.chown(staged, earlier.st_uid, earlier.st_gid)
            staged.chmod(earlier.st_mode & 0o7777)
            return staged
        except OSError:
            shutil.rmtree(staged, ignore_errors=True)
    staged = folder / NEW
    staged.mkdir()
    return staged


def publish(staged, folder, own, locks):
    sync_tree(staged)
    if staged.parent != folder:
        lock(staged, locks)
        try:
            for path in folder.iterdir():
                if path.name not in own:
                    os.link(path, staged / path.name, follow_symlinks=False)
            sync(staged)
            exchange(staged, folder)
        except OSError:
            for path in folder.iterdir():
                if path.name not in own:
                    (staged / path.name).unlink(missing_ok=True)
            staged = staged.rename(folder / NEW)
        else:
            sync(folder.parent)
            remove_earlier(folder, own)
            return
    staged.rename(folder / READY)
    sync(folder)
    replace_each(folder, own)
    sync(folder.parent)


def remove_earlier(folder, own):
    old = beside(folder)
    for path in sorted(old.iterdir()):
        if path.name not in own and not os.path.lexists(folder / path.name):
            path.rename(folder / path.name)  # of another program, and came in the last moment
    shutil.rmtree(old, ignore_errors=True)


def replace_each(folder, own):
    ready, moving = folder / READY, folder / MOVING
    if ready.is_dir():
        for name in own:
            if not (ready / name).exists():
                remove(folder / name)
        ready.rename(moving)
    if moving.is_dir():
        for path in sorted(moving.iterdir()):
            if (folder / path.name).is_dir():
                remove(folder / path.name)
            path.rename(folder / path.name)
        moving.rmdir()
        sync(folder)


def remove(path):
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def exchange(a, b):
    libc = ctypes.CDLL(None, use_errno=True)
    renameat2 = getattr(libc, "renameat2", None)
    if renameat2 is None:
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    if renameat2(AT_FDCWD, os.fsencode(a), AT_FDCWD, os.fsencode(b), RENAME_EXCHANGE) != 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()), str(b))


def sync_tree(folder):
    for parent, _, names in os.walk(folder, topdown=False):
        for name in names:
            sync(pathlib.Path(parent) / name)
        sync(pathlib.Path(parent))


def sync(path):
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno not in (errno.EINVAL, errno.ENOTSUP):
            raise FileError(f"{path}: cannot be written: {error.strerror}") from error
    finally:
        os.close(handle)
