"""Files from servers, through the network stack of QGIS: its proxy and authentication count."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from qgis.core import QgsApplication, QgsFeedback, QgsNetworkAccessManager
from qgis.PyQt.QtCore import QEventLoop, QUrl
from qgis.PyQt.QtNetwork import QNetworkReply, QNetworkRequest

from ..muysc_qgis.errors import Cancelled, MuyscError
from ..muysc_qgis.topography.srtm import public_part

#: Times that a server may send on to another address; more is a loop.
_MOST_REDIRECTS = 10

#: Pause before the first new attempt (s); each further one is twice as long.
_FIRST_PAUSE_S = 0.5
#: How often a request, and a pause, look for a cancel (s).
_LOOK_S = 0.01

#: Answers after which another attempt may help: timeouts, too many requests, and what
#: went wrong at the server (RFC 9110, RFC 6585).
_PASSING_STATUS = (408, 429, *range(500, 600))
_NOTHING_THERE = (404, 410)

_ERRORS = QNetworkReply.NetworkError
#: Failures that stay, however often one tries.
_LASTING_ERRORS = (
    _ERRORS.TooManyRedirectsError,
    _ERRORS.InsecureRedirectError,
    _ERRORS.SslHandshakeFailedError,
    _ERRORS.ProtocolUnknownError,
)


@dataclass(frozen=True)
class _Answer:
    """What came of one attempt."""

    payload: bytes | None = None
    #: What went wrong, as the end of “… answered with”; empty where nothing did.
    failure: str = ""
    #: Whether another attempt may help.
    passing: bool = False


def fetcher(
    feedback: QgsFeedback,
    authentication: str = "",
    timeout_s: float | None = None,
    retries: int = 3,
) -> Callable[[str, int], bytes | None]:
    """Return a function that gets a file by its address, with the bytes that may come.

    The function returns what came, None where the server has nothing there. It
    raises `MuyscError` with the last failure, and `Cancelled` as soon as the
    feedback is cancelled.

    Parameters
    ----------
    feedback
        Asked whether to stop.
    authentication
        Id of an authentication configuration of QGIS, empty for none.
    timeout_s
        Seconds without a byte that end an attempt; None for QGIS's own setting.
    retries
        Further attempts, with growing pauses, where they may help.
    """

    def fetch(url: str, most_bytes: int) -> bytes | None:
        if url.startswith("file:"):
            return _from_disk(url, most_bytes)
        pause_s = _FIRST_PAUSE_S
        answer = _attempt(url, most_bytes, feedback, authentication, timeout_s)
        attempts = 1
        while answer.passing and attempts <= retries:
            _wait(pause_s, feedback)
            pause_s *= 2
            answer = _attempt(url, most_bytes, feedback, authentication, timeout_s)
            attempts += 1
        if answer.failure:
            times = f" {attempts} times" if attempts > 1 else ""
            raise MuyscError(f"{public_part(url)} failed{times}: {answer.failure}.")
        return answer.payload

    return fetch


def _attempt(
    url: str, most_bytes: int, feedback: QgsFeedback, authentication: str, timeout_s: float | None
) -> _Answer:
    """Send one request and wait for what becomes of it.

    Waits by itself: a QgsBlockingNetworkRequest that is cancelled in the moment when it is
    sent waits for ever, or ends QGIS.
    """
    request, manager = _request(url, timeout_s), QgsApplication.authManager()
    if authentication:
        usable, request = manager.updateNetworkRequest(request, authentication)
        if not usable:
            return _Answer(failure="the authentication (AUTHCFG) cannot be used; check it")
    reply = QgsNetworkAccessManager.instance().get(request)
    try:
        if authentication:
            manager.updateNetworkReply(reply, authentication)
        loop = QEventLoop()
        while not reply.isFinished():
            if feedback.isCanceled():
                raise Cancelled("stopped on request")
            announced = reply.header(QNetworkRequest.KnownHeaders.ContentLengthHeader) or 0
            size = max(announced, reply.bytesAvailable())
            if size > most_bytes:
                return _Answer(failure=_too_large(size, most_bytes))
            loop.processEvents()
            time.sleep(_LOOK_S)
        return _answer(reply, most_bytes)
    finally:
        reply.abort()
        reply.deleteLater()


def _request(url: str, timeout_s: float | None) -> QNetworkRequest:
    request = QNetworkRequest(QUrl(url))
    # As it is stored: Qt would unpack what is packed for the journey, without a limit.
    request.setRawHeader(b"Accept-Encoding", b"identity")
    attributes, policies = QNetworkRequest.Attribute, QNetworkRequest.RedirectPolicy
    for attribute, value in (
        (attributes.RedirectPolicyAttribute, policies.NoLessSafeRedirectPolicy),
        (attributes.CacheLoadControlAttribute, QNetworkRequest.CacheLoadControl.AlwaysNetwork),
        # The tiles have a cache of their own.
        (attributes.CacheSaveControlAttribute, False),
    ):
        # Enumerations are numbers in Qt 5, and hold one in Qt 6.
        request.setAttribute(attribute, getattr(value, "value", value))
    request.setMaximumRedirectsAllowed(_MOST_REDIRECTS)
    # New in Qt 5.15; before, the timeout of QGIS's settings holds.
    if timeout_s is not None and hasattr(request, "setTransferTimeout"):
        request.setTransferTimeout(round(1000 * timeout_s))
    return request


def _answer(reply: QNetworkReply, most_bytes: int) -> _Answer:
    """Return what became of a request that has ended."""
    error = reply.error()
    status = reply.attribute(QNetworkRequest.Attribute.HttpStatusCodeAttribute)
    if error == _ERRORS.OperationCanceledError:
        return _Answer(
            failure="it stopped sending; try again later, or raise TIMEOUT", passing=True
        )
    if status in _NOTHING_THERE:
        return _Answer()
    if status in (401, 403, 407):
        return _Answer(
            failure=f"access was refused (status {status}); choose an authentication (AUTHCFG), or "
            "set the proxy in the settings of QGIS"
        )
    if error == _ERRORS.NoError and status == 200:
        payload = bytes(reply.readAll())
        if len(payload) > most_bytes:
            return _Answer(failure=_too_large(len(payload), most_bytes))
        return _Answer(payload)
    lasting = error in _LASTING_ERRORS
    told = lasting or status in (None, 200)
    detail = _without_address(reply.errorString()) if told else f"status {status}"
    return _Answer(
        failure=f"{detail}; check the connection and SOURCE, or try again later",
        passing=not lasting and status in (None, 200, *_PASSING_STATUS),
    )


def _too_large(size: int, most_bytes: int) -> str:
    return f"it sends {size} bytes, more than the {most_bytes} that a tile can have; check SOURCE"


def _without_address(text: str) -> str:
    """Return an error message of Qt without the address, which may hold a key."""
    words = (word for word in text.strip().rstrip(".").split() if "://" not in word)
    return " ".join(words)


def _from_disk(url: str, most_bytes: int) -> bytes | None:
    path = Path(QUrl(url).toLocalFile())
    if not path.is_file():
        return None
    try:
        if path.stat().st_size > most_bytes:
            raise MuyscError(
                f"{path} has {path.stat().st_size} bytes, more than the {most_bytes} that a tile "
                "can have; check SOURCE."
            )
        return path.read_bytes()
    except OSError as error:
        raise MuyscError(
            f"{path} cannot be read ({error.strerror}); check its permissions."
        ) from error


def _wait(seconds: float, feedback: QgsFeedback) -> None:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if feedback.isCanceled():
            raise Cancelled("stopped on request")
        time.sleep(_LOOK_S)
