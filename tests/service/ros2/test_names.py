import pytest
import zenoh

from service.ros2.messages import DETECTIONS, JOINT_STATE, POINT_CLOUD2, TRANSFORMS, type_hash
from service.ros2.names import Domain, Topic, TopicNameError, check_topic
from tests.service.ros2.peers import HASHES

POINTS = Topic("/camera/depth/points", POINT_CLOUD2)
DOMAIN = Domain(3, hashes=True)


@pytest.mark.parametrize("name", [POINT_CLOUD2, DETECTIONS, JOINT_STATE, TRANSFORMS])
def test_hashes_are_those_of_the_distributions(name: str) -> None:
    assert type_hash(name) == HASHES[name]


def test_keys_of_a_topic() -> None:
    head = "3/camera/depth/points/sensor_msgs::msg::dds_::PointCloud2_"
    assert DOMAIN.publisher_key(POINTS) == f"{head}/{HASHES[POINT_CLOUD2]}"
    assert Domain(3, hashes=False).publisher_key(POINTS) == f"{head}/TypeHashNotSupported"
    assert POINTS.bridge_key == "camera/depth/points"


def test_a_subscription_hears_every_distribution_and_no_other_topic() -> None:
    heard = zenoh.KeyExpr(DOMAIN.subscriber_key(POINTS))
    for hashes in (True, False):
        assert heard.intersects(zenoh.KeyExpr(Domain(3, hashes).publisher_key(POINTS)))
    assert not heard.intersects(zenoh.KeyExpr(Domain(4, hashes=True).publisher_key(POINTS)))
    assert not heard.intersects(zenoh.KeyExpr(DOMAIN.publisher_key(Topic("/camera/depth/points/x", POINT_CLOUD2))))
    assert not heard.intersects(zenoh.KeyExpr(DOMAIN.publisher_key(Topic(POINTS.name, JOINT_STATE))))


def test_tokens_read_as_in_the_design_of_rmw_zenoh() -> None:
    assert DOMAIN.node_token("aac3178e", "captra") == "@ros2_lv/3/aac3178e/0/0/NN/%/%/captra"
    tf = Topic("/tf", TRANSFORMS, depth=7)
    assert DOMAIN.topic_token("aac3178e", "captra", 10, "MP", tf) == (
        f"@ros2_lv/3/aac3178e/0/10/MP/%/%/captra/%tf/tf2_msgs::msg::dds_::TFMessage_/{HASHES[TRANSFORMS]}/::,7:,:,:,,"
    )
    assert "/%camera%depth%points/" in DOMAIN.topic_token("a", "captra", 1, "MS", POINTS)


@pytest.mark.parametrize("name", ["/tf", "/camera/depth/points", "/_a/b1", "/a_b"])
def test_topics_are_taken(name: str) -> None:
    assert check_topic(name) == name


@pytest.mark.parametrize(
    "name", ["", "/", "tf", "/tf/", "//tf", "/1a", "/a b", "/a/*", "/a/**", "/a$b", "/a__b", "/a_", "~/a"]
)
def test_other_names_are_refused(name: str) -> None:
    with pytest.raises(TopicNameError, match="/camera/depth/points"):
        check_topic(name)
