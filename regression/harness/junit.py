"""Results as JUnit XML."""

import re
import xml.etree.ElementTree as ElementTree

from .run_case import SKIPPED


def write_junit(path, results):
    failures, skipped = sum(r.failed for r in results), sum(r.status == SKIPPED for r in results)
    suite = ElementTree.Element("testsuite", name="ndregress", tests=str(len(results)), failures=str(failures),
                                errors="0", skipped=str(skipped), time=f"{sum(r.seconds for r in results):.3f}")
    for result in results:
        case = ElementTree.SubElement(suite, "testcase", classname="regression", name=result.name,
                                      time=f"{result.seconds:.3f}")
        if result.failed:
            ElementTree.SubElement(case, "failure", message=result.status).text = printable(result.details)
        elif result.status == SKIPPED:
            ElementTree.SubElement(case, "skipped", message=printable(result.details))
        ElementTree.SubElement(case, "system-out").text = printable(result.case.requirement)
    suites = ElementTree.Element("testsuites")
    suites.append(suite)
    ElementTree.indent(suites)
    ElementTree.ElementTree(suites).write(path, encoding="utf-8", xml_declaration=True)


def printable(text):
    """XML 1.0 knows no control characters but tab and the ends of lines."""
    return re.sub(r"[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "?", text)
