"""`kerfline send` that is killed or disconnected, and then resumes or begins within a job."""
import concurrent.futures
import signal
import subprocess
import time

from relays import Rewriter
from send_bench import SETTINGS, SendBench, served


class SendResumeTest(SendBench):
    def test_resumes_after_the_alarm_of_a_silent_link(self):
        server = self.serve("--tcp", 0, *SETTINGS)
        where = ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        job = self.program_file(["G21 G90 M4 S500", "G1 X40 F600", "Y1", "M5"])
        sender = server.tcp()
        sender.until(served.BANNER)
        for line in ("N1G21G90M4S500", "N2G1X40F600"):
            sender.send(line.encode() + b"\n")
        sender.until("ALARM:25", seconds=20)  # The port stays open, and nothing comes any more.
        sender.close()
        status, out, err = self.send(job, *where, "--numbered", "--resume")
        self.assertEqual(status, 0, err + out)
        self.assertIn("begins with line 2", out)
        deadline = time.monotonic() + 5
        while time.monotonic() < deadline and self.where(server)[:2] != [40.0, 1.0]:
            time.sleep(0.2)
        self.assertEqual(self.where(server)[:2], [40.0, 1.0])

    def test_killed_on_a_can_bus_leaves_the_beam_dark(self):
        server = self.serve("--slcan", self.link, "--tcp", 0, *SETTINGS)
        self.check_dark_when_killed(server, "--slcan", self.link)

    def test_killed_leaves_the_beam_dark(self):
        for link in ("pty", "tcp"):
            with self.subTest(link=link):
                server = self.serve("--pty", self.link, "--tcp", 0, *SETTINGS)
                where = (("--port", self.link) if link == "pty"
                         else ("--tcp", f"127.0.0.1:{server.port('tcp')}"))
                self.check_dark_when_killed(server, *where)

    def ring(self):
        """Returns a part whose path never comes near itself, and its length in mm."""
        lines = ["G21 G90 M4 S500 F2400"]
        for row in range(8):
            ends = (0, 20) if row % 2 == 0 else (20, 0)
            lines += [f"G1 X{ends[0]} Y{3 * row}", f"(row {row})", f"X{ends[1]}"]
        return self.program_file(lines + ["G2 X5 Y26 I0 J5", "M5", "M2"])

    def burnt(self, trace):
        """Returns the positions of the steps with the beam on, and the number of such steps at each."""
        places = {}
        last = None
        for row in trace.read_text().splitlines():
            if not row[:1].isdigit():
                continue
            fields = row.split(",")
            place, lit = tuple(fields[1:3]), float(fields[7]) > 0
            if lit and place != last:
                places[place] = places.get(place, 0) + 1
            last = place
        return places

    def test_goes_on_where_a_killed_sender_left_the_part(self):
        job = self.ring()
        whole = self.folder / "whole.csv"
        subprocess.run([self.program, "sim", str(job), *SETTINGS, "--trace", str(whole)],
                       check=True, stdout=subprocess.DEVNULL)
        expected = self.burnt(whole)
        ways = (("pty", "--numbered"), ("tcp", "--checked"))
        with concurrent.futures.ThreadPoolExecutor(len(ways)) as threads:
            ends = threads.map(lambda way: self.kill_and_resume(job, *way), ways)
        for (link, form), (status, out, err, stopped) in zip(ways, ends):
            with self.subTest(link=link, form=form):
                self.assertEqual((status, err), (0, ""))
                self.assertIn("begins with line ", out)
                self.assertNotIn("begins with line 1\n", out)
                self.assertEqual(stopped, 0)
                burnt = self.burnt(self.folder / f"{link}.csv")
                # 250 steps are a millimetre, so 40 mm/s are 10 steps per millisecond.
                left = [place for place in expected if place not in burnt]
                twice = [place for place in burnt if burnt[place] > expected.get(place, 0)]
                self.assertLess(len(left), 12)
                self.assertLess(len(twice), 40)

    def kill_and_resume(self, job, link, form):
        """Returns status, output and errors of the sender that resumes, and the server's final status."""
        options = ("--pty", self.link) if link == "pty" else ("--tcp", 0)
        server = self.serve(*options, "--trace", self.folder / f"{link}.csv", *SETTINGS)
        where = ("--port", self.link) if link == "pty" else ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        process = self.start(job, *where, form)
        time.sleep(3.0)
        process.send_signal(signal.SIGKILL)
        process.communicate(timeout=20)
        time.sleep(1.0)
        return (*self.send(job, *where, form, "--resume"), server.stop()[0])

    def test_begins_within_a_job(self):
        server = self.serve("--tcp", 0, "--speed", 20, *SETTINGS)
        where = ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        job = self.program_file(["G20 G90", "G0 X1", "M3 S300", "G1 F100 X2", "G2 X3 I0.5",
                                 "X4 I0.5", "G91 G1 X1", "X1", "M5"])
        log = self.folder / "log"
        status, out, err = self.send(job, *where, "--from-line", 6, "--log", log)
        self.assertEqual((status, err), (0, ""))
        self.assertIn("begins with line 6\n", out)
        said = [line.split(" > ")[1] for line in log.read_text().splitlines() if " > " in line]
        self.assertEqual(said[-4:], ["G2X4I0.5", "G91G1X1", "X1", "M5"])
        self.assertIn("G0X76.200000", said)
        self.assertIn("G20G90G94", said)
        self.check_x(server, 6 * 25.4)
        for words, why in ((["G91 G0 X1", "X1"], "the position of X at that line depends"),
                           (["G92 X3", "G1 X1 F100"], "G92 is in use"),
                           (["G99", "G1 X1 F100"], "line 1: ")):
            status, _, err = self.send(self.program_file(words), *where, "--from-line", 2,
                                       "--accept-faults")
            self.assertEqual(status, 2)
            self.assertIn(why, err)
        status, _, err = self.send(job, *where, "--from-line", 10)
        self.assertIn("line 10 does not exist", err)
        status, _, err = self.send(job, *where, "--resume")
        self.assertEqual(status, 2)
        self.assertIn("knows of no job that was interrupted", err)

    def test_checks_the_lines_that_lead_to_the_beginning_within_a_job(self):
        server = self.serve("--tcp", 0, "--speed", 20, *SETTINGS)
        relay = Rewriter(server.port("tcp"), to_machine=[(b"G0X51", b"G0X91")])
        job = self.program_file(["G21 G90", "G0 X50", "G91 G1 F6000 X1", "X1", "X1"])
        log = self.folder / "log"
        status, _, err = self.send(job, "--tcp", f"127.0.0.1:{relay.port}", "--checked",
                                   "--from-line", 4, "--log", log)
        self.assertEqual((status, err), (0, ""))
        self.assertEqual(relay.to_machine, [])
        said = [line.split(" > ")[1] for line in log.read_text().splitlines() if " > " in line]
        self.assertEqual({line for line in said if "*" not in line}, {"", "$I"})
        self.assertEqual(sum("G0X51" in line for line in said), 2)
        self.check_x(server, 53.0)


if __name__ == "__main__":
    served.main(in_test=4)
